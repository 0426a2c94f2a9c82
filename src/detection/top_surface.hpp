// Height and evenness of a top, away from its edges.
#pragma once

#include <cstddef>

#include <mixed_palletizing/geometry/rectangle.hpp>

#include "base_cloud.hpp"
#include "grid_runs.hpp"

namespace mixed_palletizing::detection {

struct TopSurface {
  double height_m = 0.0;  ///< mean of the heights, trimmed to the same distance above and below
  double stddev_m = 0.0;
  std::size_t count = 0;  ///< points, or cells of points, that the mean is taken over and the deviation is of
  double uneven_m = 0.0;  ///< largest distance of a well filled cell's mean height from the height: bulges,
                          ///< dents and tilt count, noise averages out
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< rise over run along x and y of the base frame
  bool whole = true;                                ///< seen all over, but for a rim

  /// Upwards, length 1, base frame.
  Eigen::Vector3d normal() const { return Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized(); }
};

/// Surface of the points of `top` well inside the rectangle. `start_m` is the height found so far; points farther
/// from the mean than start_m - low_m are left out, because the top itself was cut at low_m.
TopSurface measureSurface(const BaseCloud& cloud, const RunRange& top, const geometry::Rectangle& rectangle,
                          double start_m, double low_m);

}  // namespace mixed_palletizing::detection
