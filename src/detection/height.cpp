#include "height.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

// A patch is believed when its level holds at least this share of the densest level's points.
constexpr double kBelievablePatch = 0.5;

/// Mean and standard deviation of the heights within +-reach of a level, from the profile.
void momentsAround(const HeightProfile& profile, double level_m, double reach_m, TopLevel& level) {
  double n = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < profile.counts.size(); ++i) {
    const double offset = (static_cast<double>(i) + 0.5) * profile.slice_m - level_m;
    if (std::abs(offset) > reach_m) continue;
    n += profile.counts[i];
    sum += profile.counts[i] * offset;
    squares += profile.counts[i] * offset * offset;
  }
  if (n < 1.0) return;
  level.height_m = level_m + sum / n;
  level.stddev_m = std::sqrt(std::max(0.0, squares / n - (sum / n) * (sum / n)));
}

}  // namespace

std::optional<double> patchHeight(const BaseCloud& cloud, const RunRange& cluster, const ClusterShape& shape,
                                  double radius_m) {
  const Eigen::Vector2f center = shape.centroid.head<2>().cast<float>();
  const float squared_radius = static_cast<float>(radius_m * radius_m);
  double sum = 0.0;
  std::size_t count = 0;
  const int stride = meanStride(shape.count);
  for (const Run& run : cluster) {
    if (run.row % stride != 0) continue;
    for (int col = run.begin; col < run.end; col += stride) {
      const Eigen::Vector3f p = cloud.point(run.row, col);
      if ((p.head<2>() - center).squaredNorm() > squared_radius) continue;
      sum += p.z();
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

TopLevel findTopLevel(const HeightProfile& profile, std::optional<double> patch_height_m, double floor_m,
                      double window_m) {
  TopLevel level;
  double densest = 0.0;
  const double half = 0.5 * window_m;
  for (std::size_t i = 0; i < profile.counts.size(); ++i) {
    const double at = (static_cast<double>(i) + 0.5) * profile.slice_m;
    if (at < floor_m) continue;
    const double points = profile.between(at - half, at + half);
    if (points <= densest) continue;
    densest = points;
    level.height_m = at;
  }
  if (patch_height_m && *patch_height_m > floor_m &&
      profile.between(*patch_height_m - half, *patch_height_m + half) > kBelievablePatch * densest) {
    level.height_m = *patch_height_m;
  }
  // Two rounds: the first moves the window onto the middle of the peak.
  momentsAround(profile, level.height_m, half, level);
  momentsAround(profile, level.height_m, half, level);
  const double slice = profile.slice_m;
  level.peak_density = profile.between(level.height_m - half, level.height_m + half) * slice / window_m;
  const double middle_low = std::max(floor_m, 0.3 * level.height_m);
  const double middle_high = std::max(middle_low + slice, 0.7 * level.height_m);
  level.side_density = profile.between(middle_low, middle_high) * slice / (middle_high - middle_low);
  return level;
}

}  // namespace mixed_palletizing::detection
