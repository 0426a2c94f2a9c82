#include "board_fit.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace mixed_palletizing::detection {

BoardFit fitBoard(const std::vector<PlaneMarker>& seen, const std::vector<BoardMarker>& places) {
  const double n = 4.0 * static_cast<double>(seen.size());
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> pairs;  // on the board, on the floor
  Eigen::Vector2d board_mean = Eigen::Vector2d::Zero();
  Eigen::Vector2d floor_mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    PlaneMarker known = seen[i];
    known.center = {places[i].x_m, places[i].y_m};
    known.yaw_rad = places[i].yaw_rad;
    const auto from = known.corners();
    const auto to = seen[i].corners();
    for (std::size_t k = 0; k < 4; ++k) {
      pairs.emplace_back(from[k], to[k]);
      board_mean += from[k] / n;
      floor_mean += to[k] / n;
    }
  }
  double along = 0.0;
  double across = 0.0;
  for (const auto& [from, to] : pairs) {
    const Eigen::Vector2d a = from - board_mean;
    const Eigen::Vector2d b = to - floor_mean;
    along += a.dot(b);
    across += a.x() * b.y() - a.y() * b.x();
  }
  BoardFit fit;
  fit.yaw_rad = std::atan2(across, along);
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(fit.yaw_rad).toRotationMatrix();
  fit.origin = floor_mean - turn * board_mean;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double error = (fit.origin + turn * pairs[i].first - pairs[i].second).norm();
    fit.rms_m += error * error / n;
    if (error < fit.worst_m) continue;
    fit.worst_m = error;
    fit.worst_id = places[i / 4].id;
  }
  fit.rms_m = std::sqrt(fit.rms_m);
  return fit;
}

}  // namespace mixed_palletizing::detection
