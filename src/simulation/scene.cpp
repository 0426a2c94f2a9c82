#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

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
