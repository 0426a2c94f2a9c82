// The things of a scene as the ray caster needs them: shape and paint.
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/simulation/scene.hpp>

#include "ray_scene.hpp"

namespace mixed_palletizing::simulation {

/// Paint of an object.
class Surface {
 public:
  virtual ~Surface() = default;

  /// Colour (r, g, b) in [0, 255] without light, where the ray along `direction` (optical frame, z = 1) hits.
  virtual Eigen::Vector3f albedo(const RayHit& hit, const Eigen::Vector3d& direction) const = 0;
};

struct SceneObject {
  Mesh mesh;
  std::unique_ptr<Surface> surface;
};

/// Object 0 is the floor with the marker, object i + 1 is scene.boxes[i].
std::vector<SceneObject> buildObjects(const Scene& scene);

/// Corners of a box's top in the optical frame [m], in order around it: of the nominal plane, less the half of
/// the rounded edges that belongs to the sides.
std::vector<Eigen::Vector3d> topCorners(const SceneBox& box, const geometry::Pose& camera_from_world);

}  // namespace mixed_palletizing::simulation
