#include "cloud_content.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace mixed_palletizing::adapters {
namespace {

constexpr int kSamplesPerSide = 120;
constexpr std::size_t kMinSamplesOfDirection = 50;
constexpr double kMinDirectionCorrelation =
    0.5;  // 1 for a camera, 0 for a transposed, -1 for a mirrored grid
constexpr double kNearestM = 0.01;
constexpr double kFarthestM = 50.0;

/// Running correlation of grid position and viewing direction.
struct Direction {
  double n = 0, sum_g = 0, sum_d = 0, sum_gg = 0, sum_dd = 0, sum_gd = 0;

  void add(double grid, double direction) {
    n += 1;
    sum_g += grid;
    sum_d += direction;
    sum_gg += grid * grid;
    sum_dd += direction * direction;
    sum_gd += grid * direction;
  }
  /// In [-1, 1]; 1 when the samples do not spread.
  double correlation() const {
    const double var_g = sum_gg - sum_g * sum_g / n;
    const double var_d = sum_dd - sum_d * sum_d / n;
    const double covariance = sum_gd - sum_g * sum_d / n;
    return var_g > 0 && var_d > 0 ? covariance / std::sqrt(var_g * var_d) : 1.0;
  }
};

struct Samples {
  Direction columns;
  Direction rows;
  std::vector<float> depths;
};

Samples sample(const geometry::CloudView& view) {
  Samples samples;
  const int row_stride = std::max(1, view.height / kSamplesPerSide);
  const int col_stride = std::max(1, view.width / kSamplesPerSide);
  for (int row = row_stride / 2; row < view.height; row += row_stride) {
    for (int col = col_stride / 2; col < view.width; col += col_stride) {
      const Eigen::Vector3f p = view.point(row, col);
      if (!p.allFinite()) continue;
      samples.depths.push_back(p.z());
      if (p.z() <= 0.0f) continue;
      samples.columns.add(col, static_cast<double>(p.x()) / static_cast<double>(p.z()));
      samples.rows.add(row, static_cast<double>(p.y()) / static_cast<double>(p.z()));
    }
  }
  return samples;
}

bool hasFinitePoint(const geometry::CloudView& view) {
  for (int row = 0; row < view.height; ++row) {
    for (int col = 0; col < view.width; ++col) {
      if (view.point(row, col).allFinite()) return true;
    }
  }
  return false;
}

}  // namespace

CheckedCloud checkContent(const geometry::CloudView& view) {
  Samples samples = sample(view);
  if (samples.depths.empty()) {
    return hasFinitePoint(view) ? CheckedCloud{} : faulty(CloudFault::kNoData, "not one point has data");
  }
  const auto middle = samples.depths.begin() + static_cast<std::ptrdiff_t>(samples.depths.size() / 2);
  std::nth_element(samples.depths.begin(), middle, samples.depths.end());
  const double depth = static_cast<double>(*middle);
  if (depth < kNearestM || depth > kFarthestM) {
    return faulty(CloudFault::kImplausibleScale,
                  "the median depth is " + std::to_string(depth) + " m: metres along z forward are expected");
  }
  if (samples.columns.n < static_cast<double>(kMinSamplesOfDirection)) return {};
  const double columns = samples.columns.correlation();
  const double rows = samples.rows.correlation();
  if (columns < kMinDirectionCorrelation || rows < kMinDirectionCorrelation) {
    return faulty(CloudFault::kMirrored, "x must grow with the column (correlation " +
                                             std::to_string(columns) + ") and y with the row (" +
                                             std::to_string(rows) + ")");
  }
  return {};
}

}  // namespace mixed_palletizing::adapters
