#include <algorithm>
#include <cmath>

#include <mixed_palletizing/experiments/box_pairing.hpp>
#include <mixed_palletizing/geometry/line2d.hpp>
#include <mixed_palletizing/geometry/polygon.hpp>

namespace mixed_palletizing::experiments {
namespace {

/// The part of a convex polygon on the left of a -> b (Sutherland and Hodgman).
geometry::Polygon leftOf(const geometry::Polygon& polygon, const Eigen::Vector2d& a,
                         const Eigen::Vector2d& b) {
  const geometry::Line2d line = geometry::Line2d::through(a, b);
  geometry::Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& p = polygon[i];
    const Eigen::Vector2d& q = polygon[(i + 1) % polygon.size()];
    const double from = line.signedDistance(p);
    const double to = line.signedDistance(q);
    if (from >= 0.0) kept.push_back(p);
    if ((from >= 0.0) != (to >= 0.0)) kept.push_back(p + (q - p) * (from / (from - to)));
  }
  return kept;
}

/// Share of the union of both footprints; nothing when the detection is not this box.
std::optional<double> agreement(const TrueBox& truth, const detection::DetectedBox& box) {
  if (std::abs(box.top_center.z() - truth.top_center.z()) > kHighestStep) return std::nullopt;
  const geometry::Rectangle seen{box.top_center.head<2>(), box.yaw_rad, box.size.head<2>()};
  const geometry::Rectangle real = truth.footprint();
  if (!(seen.area() > 0.0) || !(real.area() > 0.0)) return std::nullopt;
  const double shared = sharedArea(seen, real);
  const double overlap = shared / (seen.area() + real.area() - shared);
  const double shift = (seen.center - real.center).norm();
  if (overlap >= kLeastOverlap && shift <= kLargestShift * truth.size.y()) return overlap;
  const unsigned partial = detection::kOccluded | detection::kTruncated | detection::kIncomplete;
  const bool hidden = truth.visible_ratio < kWholeTop;
  const bool excused = (hidden && (box.flags & partial) != 0u) || !truth.counts();
  if (excused && shared >= kLeastInside * std::min(seen.area(), real.area())) return overlap;
  return std::nullopt;
}

struct Pair {
  double overlap;
  std::size_t truth;
  std::size_t detected;
};

}  // namespace

double sharedArea(const geometry::Rectangle& a, const geometry::Rectangle& b) {
  const auto corners = a.corners();
  geometry::Polygon polygon(corners.begin(), corners.end());
  const auto cut = b.corners();
  for (std::size_t i = 0; i < 4 && !polygon.empty(); ++i) polygon = leftOf(polygon, cut[i], cut[(i + 1) % 4]);
  return std::max(0.0, geometry::signedArea(polygon));
}

std::vector<std::optional<std::size_t>> pairBoxes(const std::vector<TrueBox>& truth,
                                                  const std::vector<detection::DetectedBox>& detected) {
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    for (std::size_t d = 0; d < detected.size(); ++d) {
      if (const auto overlap = agreement(truth[t], detected[d])) pairs.push_back({*overlap, t, d});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.overlap > b.overlap; });
  std::vector<std::optional<std::size_t>> found(truth.size());
  std::vector<bool> taken(detected.size(), false);
  for (const Pair& pair : pairs) {
    if (found[pair.truth] || taken[pair.detected]) continue;
    found[pair.truth] = pair.detected;
    taken[pair.detected] = true;
  }
  return found;
}

}  // namespace mixed_palletizing::experiments
