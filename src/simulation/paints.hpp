// Paint of the things of a scene.
#pragma once

#include <memory>

#include <Eigen/Core>

#include <mixed_palletizing/simulation/scene.hpp>

#include "ray_scene.hpp"

namespace mixed_palletizing::simulation {

class Paint {
 public:
  virtual ~Paint() = default;

  /// Colour (r, g, b) in [0, 255] without light, where the ray along `direction` (optical frame, z = 1) hits.
  virtual Eigen::Vector3f albedo(const RayHit& hit, const Eigen::Vector3d& direction) const = 0;
};

std::unique_ptr<Paint> plainPaint(std::uint32_t rgb);

/// Paint of a surface of the scene (`surface.name` empty: the floor) with the markers and boards that lie on it.
/// Its mesh calls the upper side face 0.
std::unique_ptr<Paint> surfacePaint(const Scene& scene, const SceneSurface& surface);

/// Paint of a box whose mesh is boxMesh().
std::unique_ptr<Paint> boxPaint(const SceneBox& box, const geometry::Pose& camera_from_box);

}  // namespace mixed_palletizing::simulation
