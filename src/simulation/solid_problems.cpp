#include <algorithm>
#include <cmath>

#include <mixed_palletizing/geometry/rectangle.hpp>

#include "rules.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr double kAllowedOverlap = 1e-4;      // [m]
constexpr double kInsideWinding = 0.5;        // of closed meshes 1 inside and 0 outside, of open ones between
constexpr double kMinSurfaceDistance = 1e-6;  // [m]

/// Whether two solids share more than touching faces.
bool overlap(const SceneBox& a, const SceneBox& b) {
  const double low = std::max(a.base_z_m, b.base_z_m);
  const auto topOf = [](const SceneBox& box) {
    return box.base_z_m + box.size_m.z() + std::max(0.0, box.shape.bulge_m);
  };
  const double high = std::min(topOf(a), topOf(b));
  if (high - low <= kAllowedOverlap) return false;
  const auto shrunk = [](const SceneBox& box) {
    const Eigen::Vector2d size = (box.size_m.head<2>().array() - kAllowedOverlap).max(0.0);
    return geometry::Rectangle{box.position_m, box.yaw_rad, size};
  };
  return !(geometry::distance(shrunk(a), shrunk(b)) > 0.0);
}

bool holds(const SceneBox& box, const Eigen::Vector3d& point) {
  const Eigen::Vector3d inside = worldFromBox(box).inverse() * point;
  return (inside.cwiseAbs().array() <= 0.5 * box.size_m.array()).all();
}

bool holds(const SceneSurface& surface, const Eigen::Vector3d& point) {
  const Eigen::Vector3d inside = surface.world_from_surface.inverse() * point;
  return (inside.head<2>().cwiseAbs().array() <= 0.5 * surface.size_m.array()).all() &&
         inside.z() <= kMinSurfaceDistance && inside.z() >= -surface.thickness_m - kMinSurfaceDistance;
}

bool holds(const SceneObject& object, const Eigen::Vector3d& point) {
  const Eigen::Vector3d inside = object.world_from_object.inverse() * point;
  return std::abs(windingNumber(*object.mesh, inside)) > kInsideWinding;
}

template <typename Things>
void checkHold(const Things& things, const std::string& key, const Eigen::Vector3d& eye, Rules& rules) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (holds(things[i], eye)) rules.add(key + "[" + std::to_string(i) + "]", "holds the camera");
  }
}

}  // namespace

void checkSolids(const Scene& scene, Rules& rules) {
  const auto key = [](std::size_t i) { return "boxes[" + std::to_string(i) + "]"; };
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(scene.boxes[i], scene.boxes[j])) rules.add(key(i), "overlaps " + key(j));
    }
  }
  const Eigen::Vector3d eye = scene.camera.world_from_camera.translation();
  checkHold(scene.boxes, "boxes", eye, rules);
  checkHold(scene.objects, "objects", eye, rules);
  checkHold(scene.surfaces, "surfaces", eye, rules);
}

}  // namespace mixed_palletizing::simulation
