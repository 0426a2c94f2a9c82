// Eq. 3.11 takes the difference of the two lines' distances from the origin: exact for parallel edges, and
// for others the more wrong the farther the box is from the origin. Eq. 4.1 and 4.2 intersect the edges with
// a line through the centre. The last variant of 4.1.7 turns that line until width and length add up to the
// least.
#include "edge_sizes.hpp"

#include <algorithm>
#include <cmath>

#include <mixed_palletizing/geometry/line2d.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {
namespace {

using geometry::Line2d;
using geometry::Rectangle;

using Lines = std::array<Line2d, 4>;

constexpr double kSearchHalfWidth = 0.2;  // [rad] about the median yaw
constexpr int kSearchSteps = 40;          // golden sections: 0.4 rad * 0.618^40 is below 1e-8

double offsetDistance(const Line2d& a, const Line2d& b) {
  const double sense = a.normal.dot(b.normal) < 0.0 ? -1.0 : 1.0;
  return std::abs(a.offset - sense * b.offset);
}

/// Eq. 4.2 for one pair of edges: distance of where the line through the centre meets them.
double distanceAlong(const Line2d& a, const Line2d& b, const Eigen::Vector2d& center,
                     const Eigen::Vector2d& axis) {
  const Line2d through = Line2d::through(center, center + axis);
  const auto from = intersection(a, through);
  const auto to = intersection(b, through);
  return from && to ? (*to - *from).norm() : INFINITY;
}

Rectangle measuredAlong(const Lines& lines, const Eigen::Vector2d& center, double yaw_rad) {
  Rectangle rectangle{center, yaw_rad, {0.0, 0.0}};
  rectangle.size = Eigen::Vector2d(distanceAlong(lines[3], lines[1], center, rectangle.axisX()),
                                   distanceAlong(lines[0], lines[2], center, rectangle.axisY()));
  return rectangle;
}

/// Golden section search for the yaw with the smallest sum of both sizes.
Rectangle smallestSum(const Lines& lines, const Eigen::Vector2d& center, double yaw_rad) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = yaw_rad - kSearchHalfWidth;
  double high = yaw_rad + kSearchHalfWidth;
  for (int i = 0; i < kSearchSteps; ++i) {
    const double a = high - golden * (high - low);
    const double b = low + golden * (high - low);
    const bool keep_low =
        measuredAlong(lines, center, a).size.sum() < measuredAlong(lines, center, b).size.sum();
    (keep_low ? high : low) = keep_low ? b : a;
  }
  return measuredAlong(lines, center, 0.5 * (low + high));
}

}  // namespace

std::optional<EdgeSizes> sizesFromEdges(const EdgeSides& sides) {
  Lines lines;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!sides[i]) return std::nullopt;
    lines[i] = Line2d::through(sides[i]->from, sides[i]->to);
  }
  const auto center = intersection(meanLine(lines[0], lines[2]), meanLine(lines[1], lines[3]));
  if (!center) return std::nullopt;
  const double yaw = medianYaw(sides);
  EdgeSizes sizes;
  Rectangle by_offsets{
      *center, yaw, {offsetDistance(lines[3], lines[1]), offsetDistance(lines[0], lines[2])}};
  sizes.by_offsets = by_offsets.lengthFirst();
  sizes.along_yaw = measuredAlong(lines, *center, yaw).lengthFirst();
  sizes.smallest_sum = smallestSum(lines, *center, yaw).lengthFirst();
  return sizes;
}

double largestEdgeAngle(const EdgeSides& sides) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!sides[i] || !sides[i + 2]) continue;
    const Eigen::Vector2d a = sides[i]->along();
    const Eigen::Vector2d b = -sides[i + 2]->along();
    largest = std::max(largest, std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b))));
  }
  return largest;
}

}  // namespace mixed_palletizing::detection
