#include "hidden_sides.hpp"

#include <algorithm>
#include <cmath>

#include <mixed_palletizing/geometry/pose.hpp>

#include "rectangle_sides.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr int kPlaces = 15;             // along a side
constexpr double kAlong = 0.9;          // of the side that they cover
constexpr double kStep = 0.0005;        // [m] outwards
constexpr double kFreeShare = 0.25;     // of the places: the camera looks past them, so the top has ended
constexpr double kSolidShare = 0.15;    // of the places: inside a higher box
constexpr double kParallel = 0.02;      // [rad]
constexpr double kContactReach = 0.1;   // [m] hidden behind a box that stands against the side
constexpr double kContactGap = 0.0005;  // [m]
constexpr double kContactStddev = 0.001;
constexpr double kUnseenStddev = 0.015;  // [m] a flap or a print beyond the side may have passed for the top
constexpr double kContactShare = 0.15;   // of the hidden length, that remains uncertain

/// What ends the search outwards from a side.
struct Range {
  double length_m = 0.0;
  bool contact = false;  ///< ended by a parallel side of a higher box
};

bool looksPast(const LevelContext& context, const TopGroup& group, const Eigen::Vector2d& place,
               double level) {
  const auto pixel = group.rays.pixelOf({place.x(), place.y(), level});
  if (!pixel) return false;
  const int col = static_cast<int>(std::lround(pixel->x()));
  const int row = static_cast<int>(std::lround(pixel->y()));
  if (row < 0 || col < 0 || row >= context.cloud.height() || col >= context.cloud.width()) return false;
  if (!context.cloud.valid(row, col)) return false;
  return static_cast<double>(context.cloud.point(row, col).z()) < level - 2.0 * group.scale.band_m;
}

Range rangeOf(const LevelContext& context, const std::vector<FittedTop>& tops, std::size_t self,
              std::size_t side) {
  const FittedTop& top = tops[self];
  const geometry::Rectangle& r = top.fit.rectangle;
  const Eigen::Vector2d out = kOutward[side].x() * r.axisX() + kOutward[side].y() * r.axisY();
  const Eigen::Vector2d along(-out.y(), out.x());
  const Eigen::Vector2d middle = r.center + halfAcross(r, side) * out;
  const double most = std::max(kStep, context.options.box.max_side_m - 2.0 * halfAcross(r, side));
  for (double d = kStep; d < most; d += kStep) {
    int past = 0;
    int solid = 0;
    bool parallel = false;
    for (int k = 0; k < kPlaces; ++k) {
      const double share = kAlong * (2.0 * k / (kPlaces - 1) - 1.0);
      const Eigen::Vector2d place = middle + d * out + share * halfAlong(r, side) * along;
      // The camera's view is coarser than the step: once a pixel is enough.
      past += looksPast(context, *top.group, place, top.surface.height_m) ? 1 : 0;
      for (std::size_t i = 0; i < tops.size(); ++i) {
        const FittedTop& other = tops[i];
        if (i == self || other.surface.height_m < top.surface.height_m + top.group->scale.band_m) continue;
        if (!other.fit.rectangle.contains(place)) continue;
        ++solid;
        parallel = std::abs(geometry::foldQuarterTurn(other.fit.rectangle.yaw_rad - r.yaw_rad)) < kParallel;
        break;
      }
    }
    if (past >= kFreeShare * kPlaces) return {d, false};
    if (solid >= kSolidShare * kPlaces) return {d, parallel && d < kContactReach};
  }
  return {most, false};
}

}  // namespace

void completeHidden(const LevelContext& context, std::vector<FittedTop>& tops) {
  for (std::size_t i = 0; i < tops.size(); ++i) {
    for (std::size_t side = 0; side < 4; ++side) {
      SideFit& fit = tops[i].fit.sides[side];
      if (fit.found) continue;
      const Range range = rangeOf(context, tops, i, side);
      geometry::Rectangle& r = tops[i].fit.rectangle;
      const Eigen::Vector2d out = kOutward[side].x() * r.axisX() + kOutward[side].y() * r.axisY();
      const double move = range.contact ? std::max(0.0, range.length_m - kContactGap) : 0.5 * range.length_m;
      fit.stddev_m = range.contact ? std::hypot(kContactStddev, kContactShare * range.length_m)
                                   : std::hypot(range.length_m / std::sqrt(12.0), kUnseenStddev);
      r.center += 0.5 * move * out;
      r.size(side % 2 == 0 ? 1 : 0) += move;
    }
  }
}

}  // namespace mixed_palletizing::detection
