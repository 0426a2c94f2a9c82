#include <stdexcept>

#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

geometry::Pose worldFromSurface(const Scene& scene, const std::string& surface) {
  if (surface.empty()) return geometry::Pose::Identity();
  for (const SceneSurface& known : scene.surfaces) {
    if (known.name == surface) return known.world_from_surface;
  }
  throw std::invalid_argument("worldFromSurface: surface = '" + surface + "' is none of the scene");
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

std::vector<Marker> markersOf(const MarkerBoard& board) {
  const double pitch = board.first.side_m + board.gap_m;
  const geometry::Pose surface_from_board = worldFromMarker(board.first);
  std::vector<Marker> markers;
  for (int row = 0; row < board.rows; ++row) {
    for (int col = 0; col < board.columns; ++col) {
      Marker marker = board.first;
      const Eigen::Vector3d place(pitch * (col - 0.5 * (board.columns - 1)),
                                  pitch * (0.5 * (board.rows - 1) - row), 0.0);
      marker.id = board.first.id + row * board.columns + col;
      marker.position_m = (surface_from_board * place).head<2>();
      markers.push_back(marker);
    }
  }
  return markers;
}

}  // namespace mixed_palletizing::simulation
