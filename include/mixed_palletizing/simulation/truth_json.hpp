// What is really in a simulated cloud, as JSON.
#pragma once

#include <cstdint>
#include <string>

#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

/// JSON text: seed, world_from_camera (4x4, rows), base_from_camera (likewise, null without a marker) and boxes
/// [{mask_value, name, center, top_center, yaw, pose and pose_in_camera {position, orientation x, y, z, w}, size
/// [l, w, h], top_mean_height, top_max_deviation, shape_flags, visible_pixels, visibility, top_visibility}] in metres
/// and radians in the world; length >= width, yaw of the length in [-pi/2, pi/2), poses of the box's centre with x
/// along the length and z up. Centres and size are nominal; the mean height of the real top is a z of the world, its
/// largest deviation one from the nominal plane, both within the rounded edges; the flags are shapeFlags().
/// `visibility` is the share of the pixels that the nominal box would have alone before an unlimited image. Then
/// objects [{mask_value, name, kind, world_from_object (4x4), pose and pose_in_camera, extent [low, high] in its own
/// frame, visible_pixels}] and markers [{dictionary, id, corners in the world as OpenCV orders them}], the base
/// frame's first.
std::string truthJson(const Scene& scene, const Capture& capture, std::uint64_t seed);

}  // namespace mixed_palletizing::simulation
