#include "top_plane.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

// With no side face in view the reference slice is empty; stray points must not pass for a top then.
constexpr double kStrayShare = 0.01;
// The top keeps this many standard deviations below its level, whatever the slices say.
constexpr double kKeptSigmas = 2.0;

}  // namespace

std::optional<TopBand> separateTop(const HeightProfile& profile, const TopLevel& level,
                                   const DetectionOptions& options) {
  const double depth = std::max(options.top.search_depth_m, options.noise.sigmas * level.stddev_m);
  const double slice = std::max(options.top.slice_m, 0.5 * level.stddev_m);
  const double reference =
      std::max(level.side_density, kStrayShare * level.peak_density) * slice / profile.slice_m;
  const double threshold = options.top.slice_ratio * reference;
  for (double low = level.height_m - depth; low < level.height_m; low += slice) {
    if (profile.between(low, low + slice) <= threshold) continue;
    return TopBand{std::min(low, level.height_m - kKeptSigmas * level.stddev_m), level.height_m + depth};
  }
  return std::nullopt;
}

std::optional<std::size_t> findTopPiece(const BaseCloud& cloud, const RunRange& cluster, const TopBand& band,
                                        RunForest& pieces) {
  pieces.clear();
  const float low = static_cast<float>(band.low_m);
  const float high = static_cast<float>(band.high_m);
  const Eigen::Vector3f up = cloud.upInCamera();
  const float offset = static_cast<float>(cloud.camera().z());
  const auto always = [](int) { return true; };
  for (const Run& run : cluster) {
    int begin = -1;
    for (int col = run.begin; col < run.end; ++col) {
      const float h = up.dot(cloud.view().point(run.row, col)) + offset;
      const bool inside = h > low && h < high;
      if (inside && begin < 0) begin = col;
      if (inside || begin < 0) continue;
      pieces.add(run.row, begin, col, always);
      begin = -1;
    }
    if (begin >= 0) pieces.add(run.row, begin, run.end, always);
  }
  pieces.finish();
  std::optional<std::size_t> largest;
  std::size_t most = 0;
  for (std::size_t i = 0; i < pieces.componentCount(); ++i) {
    const std::size_t count = pixelCount(pieces.component(i));
    if (count <= most) continue;
    most = count;
    largest = i;
  }
  return largest;
}

TopHeight measureHeight(const BaseCloud& cloud, const RunRange& top) {
  TopHeight height;
  const Eigen::Vector3f up = cloud.upInCamera();
  const double offset = cloud.camera().z();
  double shift = 0.0;  // the first height: keeps the squares small
  double sum = 0.0;
  double squares = 0.0;
  for (const Run& run : top) {
    for (int col = run.begin; col < run.end; ++col) {
      const double h = static_cast<double>(up.dot(cloud.view().point(run.row, col))) + offset;
      if (height.count++ == 0) shift = h;
      sum += h - shift;
      squares += (h - shift) * (h - shift);
    }
  }
  if (height.count == 0) return height;
  const double n = static_cast<double>(height.count);
  height.mean_m = shift + sum / n;
  height.stddev_m = std::sqrt(std::max(0.0, squares / n - (sum / n) * (sum / n)));
  return height;
}

}  // namespace mixed_palletizing::detection
