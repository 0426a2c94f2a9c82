// Files beside a simulated cloud: what is really in it.
#pragma once

#include <cstdint>
#include <string>

#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

/// JSON text: seed, world_from_camera (4x4, rows), base_from_camera (likewise, null without a marker) and boxes
/// [{name, center, top_center, yaw, size [l, w, h], top_mean_height, top_max_deviation, shape_flags,
/// visible_pixels, top_visibility}] in metres and radians in the world; length >= width, yaw of the length in
/// [-pi/2, pi/2). Centres and size are nominal; the mean height of the real top is a z of the world, its largest
/// deviation one from the nominal plane, both within the rounded edges; the flags are shapeFlags(). Then objects [{name, kind, world_from_object (4x4),
/// extent [low, high] in its own frame, visible_pixels}] and markers [{dictionary, id, corners in the world as
/// OpenCV orders them}], the base frame's first.
std::string truthJson(const Scene& scene, const Capture& capture, std::uint64_t seed);

/// Writes truthJson(). Throws std::runtime_error "PATH: reason".
void writeTruth(const std::string& path, const Scene& scene, const Capture& capture, std::uint64_t seed);

/// Writes the mask as 16-bit gray PNG. Throws std::invalid_argument when the path does not end in .png,
/// std::runtime_error "PATH: reason".
void writeMask(const std::string& path, const Capture& capture);

}  // namespace mixed_palletizing::simulation
