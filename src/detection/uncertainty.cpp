#include "uncertainty.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

// The floor under the box is not seen; it strays from the plane by a share of the floor's own roughness.
constexpr double kHiddenFloorShare = 0.3;
// Of the unevenness, that the mean height of a top may be off by: when it is seen all over, when parts are not seen,
// and when sides are not.
constexpr double kUnevenShare = 0.04;
constexpr double kUnevenShareParts = 0.08;
constexpr double kUnevenShareOpen = 0.25;
// [m] The mean height of what is not seen of a top, beside that of the rest: it may be dented or bulge.
constexpr double kUnseenHeight = 0.0004;
// [m] What remains of a height when nothing is noisy: the last digits of the floor's plane.
constexpr double kLeastHeight = 1e-5;

double squared(double x) { return x * x; }

/// Variance of one side's offset; a side that nothing tells of is somewhere in the rest up to the largest side.
double offsetVariance(const SideFit& side, double size_m, double max_side_m) {
  if (side.found || side.stddev_m > 0.0) return squared(side.stddev_m);
  return squared(std::max(0.25 * size_m, max_side_m - size_m)) / 12.0;
}

}  // namespace

void estimateUncertainty(const RectangleFit& fit, const TopSurface& top, double ripple_m, double max_side_m,
                         DetectedBox& box) {
  const geometry::Rectangle& r = fit.rectangle;
  std::array<double, 4> side{};
  for (std::size_t i = 0; i < 4; ++i) {
    side[i] = offsetVariance(fit.sides[i], i % 2 == 0 ? r.size.y() : r.size.x(), max_side_m);
  }
  // Sides 1 and 3 bound the rectangle's x, sides 0 and 2 its y.
  const double along_x = side[1] + side[3];
  const double along_y = side[0] + side[2];
  const double uneven_share = fit.foundSides() < 4 ? kUnevenShareOpen
                              : top.whole          ? kUnevenShare
                                                   : kUnevenShareParts;
  const double height = squared(kHiddenFloorShare * ripple_m) + squared(kLeastHeight) +
                        squared(uneven_share * top.uneven_m) +
                        squared(kUnseenHeight * (1.0 - box.top_visibility)) +
                        squared(top.stddev_m) / static_cast<double>(std::max<std::size_t>(top.count, 1));
  const bool turned = r.size.x() < r.size.y();
  box.size_stddev = Eigen::Vector3d(std::sqrt(turned ? along_y : along_x),
                                    std::sqrt(turned ? along_x : along_y), std::sqrt(height));
  box.pose_covariance.setZero();
  Eigen::Matrix2d axes;
  axes << r.axisX(), r.axisY();
  const Eigen::Vector2d center(0.25 * along_x, 0.25 * along_y);
  box.pose_covariance.topLeftCorner<2, 2>() = axes * center.asDiagonal() * axes.transpose();
  box.pose_covariance(2, 2) = 0.25 * height;
  // The top is taken for level: its tilt is unknown within the height's spread over half its side.
  const double level = squared(top.stddev_m) / squared(0.5 * std::max(r.size.minCoeff(), 1e-3));
  box.pose_covariance(3, 3) = level;
  box.pose_covariance(4, 4) = level;
  box.pose_covariance(5, 5) = squared(fit.yaw_stddev_rad);
}

}  // namespace mixed_palletizing::detection
