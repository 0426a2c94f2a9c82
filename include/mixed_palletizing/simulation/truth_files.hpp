// Files beside a simulated cloud: what is really in it.
#pragma once

#include <cstdint>
#include <string>

#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

/// JSON text: seed, world_from_camera (4x4, rows), base_from_camera (likewise, null without a marker) and boxes
/// [{name, center, top_center, yaw, size [l, w, h], visible_pixels, top_visibility}] in metres and radians in
/// the world; length >= width, yaw of the length in [-pi/2, pi/2).
std::string truthJson(const Scene& scene, const Capture& capture, std::uint64_t seed);

/// Writes truthJson(). Throws std::runtime_error "PATH: reason".
void writeTruth(const std::string& path, const Scene& scene, const Capture& capture, std::uint64_t seed);

/// Writes the mask as 16-bit gray PNG. Throws std::invalid_argument when the path does not end in .png,
/// std::runtime_error "PATH: reason".
void writeMask(const std::string& path, const Capture& capture);

}  // namespace mixed_palletizing::simulation
