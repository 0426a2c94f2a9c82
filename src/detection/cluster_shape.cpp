#include "cluster_shape.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {

double HeightProfile::between(double low_m, double high_m) const {
  const double low = std::max(0.0, low_m / slice_m);
  const double high = std::min(static_cast<double>(counts.size()), high_m / slice_m);
  double sum = 0.0;
  for (double at = low; at < high;) {
    const double next = std::min(high, std::floor(at) + 1.0);
    sum += (next - at) * counts[static_cast<std::size_t>(at)];
    at = next;
  }
  return sum;
}

void measureShape(const BaseCloud& cloud, const RunRange& cluster, double slice_m, ClusterShape& shape) {
  shape.count = 0;
  shape.profile.slice_m = slice_m;
  shape.profile.counts.clear();
  const float slices_per_m = static_cast<float>(1.0 / slice_m);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3f low = Eigen::Vector3f::Constant(INFINITY);
  Eigen::Vector3f high = -low;
  for (const Run& run : cluster) {
    Eigen::Vector3f run_sum = Eigen::Vector3f::Zero();
    for (int col = run.begin; col < run.end; ++col) {
      const Eigen::Vector3f p = cloud.point(run.row, col);
      run_sum += p;
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
      const auto slice = static_cast<std::size_t>(std::max(0.0f, p.z() * slices_per_m));
      if (slice >= shape.profile.counts.size()) shape.profile.counts.resize(slice + 1, 0);
      ++shape.profile.counts[slice];
    }
    sum += run_sum.cast<double>();
    shape.count += static_cast<std::size_t>(run.size());
  }
  shape.centroid = sum / static_cast<double>(std::max<std::size_t>(shape.count, 1));
  shape.low = low.cast<double>();
  shape.high = high.cast<double>();
}

}  // namespace mixed_palletizing::detection
