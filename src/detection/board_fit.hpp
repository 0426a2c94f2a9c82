// Where a board of markers lies on the floor.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/detection/options.hpp>

#include "marker_fit.hpp"

namespace mixed_palletizing::detection {

/// Place of the board in the axes of the floor, and how well its markers lie there.
struct BoardFit {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  double rms_m = 0.0;
  double worst_m = 0.0;
  int worst_id = 0;
};

/// Rigid motion that brings the corners of the markers' places on the board onto the seen ones, by least squares.
/// `seen` and `places` belong together one by one; at least one.
BoardFit fitBoard(const std::vector<PlaneMarker>& seen, const std::vector<BoardMarker>& places);

}  // namespace mixed_palletizing::detection
