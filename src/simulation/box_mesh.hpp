// Triangles of a carton.
#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include <mixed_palletizing/simulation/scene_box.hpp>

#include "ray_scene.hpp"

namespace mixed_palletizing::simulation {

/// What a triangle of a flap calls its face; all others have their BoxFace.
constexpr std::uint8_t kFlapFace = 6;

/// Corners of a face of the nominal cuboid counter-clockwise seen from outside, in the box's own axes [m].
std::array<Eigen::Vector3d, 4> faceCorners(const SceneBox& box, BoxFace face);

/// The box in the camera's frame: closed, curved parts within 0.05 mm of topOffset() and of the rounding, with
/// its flaps as thin slabs. Rounded edges belong to the face that they are more level with.
Mesh boxMesh(const SceneBox& box, const geometry::Pose& camera_from_box);

}  // namespace mixed_palletizing::simulation
