#include "top_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mixed_palletizing::detection {
namespace {

constexpr int kCells = 6;             // per side
constexpr double kInner = 0.92;       // of the half side: rounded and mixed edges stay out
constexpr double kFilledShare = 0.3;  // of the mean cell
constexpr std::size_t kMinPoints = 12;
constexpr int kTrimRounds = 3;

struct InnerPoint {
  float height = 0.0f;
  int cell = 0;
};

std::vector<InnerPoint> innerPoints(const BaseCloud& cloud, const RunRange& top,
                                    const geometry::Rectangle& rectangle) {
  std::vector<InnerPoint> points;
  const Eigen::Vector2f center = rectangle.center.cast<float>();
  const Eigen::Vector2f axis = rectangle.axisX().cast<float>();
  const Eigen::Array2f inner = (0.5 * kInner * rectangle.size).cast<float>();
  const Eigen::Array2f per_cell = 0.5f * kCells / inner;
  const int stride = meanStride(pixelCount(top));
  for (const Run& run : top) {
    if (run.row % stride != 0) continue;
    for (int col = run.begin; col < run.end; col += stride) {
      const Eigen::Vector3f p = cloud.point(run.row, col);
      const Eigen::Vector2f d = p.head<2>() - center;
      const Eigen::Array2f local(d.dot(axis), axis.x() * d.y() - axis.y() * d.x());
      if ((local.abs() >= inner).any()) continue;
      const Eigen::Array2i index = ((local + inner) * per_cell).cast<int>().min(kCells - 1);
      points.push_back({p.z(), index.y() * kCells + index.x()});
    }
  }
  return points;
}

/// Mean and spread of the heights nearer than `reach_m` to surface.height_m.
void trimmedMean(const std::vector<InnerPoint>& points, double reach_m, TopSurface& surface) {
  double sum = 0.0;
  double squares = 0.0;
  std::size_t count = 0;
  for (const InnerPoint& point : points) {
    const double offset = static_cast<double>(point.height) - surface.height_m;
    if (std::abs(offset) > reach_m) continue;
    sum += offset;
    squares += offset * offset;
    ++count;
  }
  if (count == 0) return;
  const double n = static_cast<double>(count);
  surface.count = count;
  surface.stddev_m = std::sqrt(std::max(0.0, squares / n - (sum / n) * (sum / n)));
  surface.height_m += sum / n;
}

double unevenness(const std::vector<InnerPoint>& points, double height_m) {
  std::array<double, kCells * kCells> sums{};
  std::array<std::size_t, kCells * kCells> counts{};
  for (const InnerPoint& point : points) {
    const auto cell = static_cast<std::size_t>(point.cell);
    sums[cell] += static_cast<double>(point.height) - height_m;
    ++counts[cell];
  }
  const auto mean_count = static_cast<double>(points.size()) / static_cast<double>(sums.size());
  const auto filled = std::max(kMinPoints, static_cast<std::size_t>(kFilledShare * mean_count));
  double largest = 0.0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (counts[i] >= filled) largest = std::max(largest, std::abs(sums[i] / static_cast<double>(counts[i])));
  }
  return largest;
}

}  // namespace

TopSurface measureSurface(const BaseCloud& cloud, const RunRange& top, const geometry::Rectangle& rectangle,
                          double start_m, double low_m) {
  TopSurface surface;
  surface.height_m = start_m;
  const std::vector<InnerPoint> points = innerPoints(cloud, top, rectangle);
  for (int i = 0; i < kTrimRounds; ++i) trimmedMean(points, surface.height_m - low_m, surface);
  surface.uneven_m = unevenness(points, surface.height_m);
  return surface;
}

}  // namespace mixed_palletizing::detection
