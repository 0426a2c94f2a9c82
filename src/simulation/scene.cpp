#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

geometry::Pose lookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector3d path = target - eye;
  if (!(path.norm() > 1e-9)) {
    throw std::invalid_argument("lookAt: eye and target are the same point or not finite");
  }
  const Eigen::Vector3d forward = path.normalized();
  const bool vertical = forward.head<2>().norm() < 1e-6;
  const Eigen::Vector3d up = vertical ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d right = forward.cross(up).normalized();
  geometry::Pose world_from_camera = geometry::Pose::Identity();
  world_from_camera.linear().col(0) = right;
  world_from_camera.linear().col(1) = forward.cross(right);
  world_from_camera.linear().col(2) = forward;
  world_from_camera.translation() = eye;
  return world_from_camera;
}

geometry::Pose worldFromMarker(const Marker& marker) {
  return geometry::poseFromYaw({marker.position_m.x(), marker.position_m.y(), 0.0}, marker.yaw_rad);
}

std::array<Eigen::Vector3d, 4> markerCorners(const Marker& marker) {
  const geometry::Pose world_from_marker = worldFromMarker(marker);
  const double half = 0.5 * marker.side_m;
  return {world_from_marker * Eigen::Vector3d(-half, half, 0),
          world_from_marker * Eigen::Vector3d(half, half, 0),
          world_from_marker * Eigen::Vector3d(half, -half, 0),
          world_from_marker * Eigen::Vector3d(-half, -half, 0)};
}

}  // namespace mixed_palletizing::simulation
