#include "clusters.hpp"

namespace mixed_palletizing::detection {
namespace {

/// Walks the rows of a cloud and cuts them into runs.
class RowCutter {
 public:
  RowCutter(const BaseCloud& cloud, const ClusterLimits& limits, RunForest& clusters)
      : cloud_(cloud),
        view_(cloud.view()),
        up_(cloud.upInCamera()),
        offset_(limits.camera_height_m),
        limits_(limits),
        clusters_(clusters) {}

  /// Returns the number of points with data.
  std::size_t cut(int row) {
    std::size_t valid = 0;
    int begin = -1;  // of the open run
    Eigen::Vector3f before = Eigen::Vector3f::Zero();
    for (int col = 0; col < view_.width; ++col) {
      const Eigen::Vector3f p = view_.point(row, col);
      const float h = height(p);
      // h - h is 0 exactly for finite numbers.
      if (h - h == 0.0f && p.z() > 0.0f) ++valid;
      if (!(h > limits_.low_m && h < limits_.high_m && p.z() > 0.0f) || outside(row, col)) {
        close(row, begin, col);
        begin = -1;
        continue;
      }
      if (begin >= 0 && !together(before, p, h)) {
        close(row, begin, col);
        begin = -1;
      }
      if (begin < 0) begin = col;
      before = p;
    }
    close(row, begin, view_.width);
    return valid;
  }

 private:
  bool outside(int row, int col) const {
    return limits_.region.limited() && !limits_.region.contains(cloud_.point(row, col));
  }

  float height(const Eigen::Vector3f& p) const {
    return up_.x() * p.x() + up_.y() * p.y() + up_.z() * p.z() + offset_;
  }

  bool together(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float height_of_b) const {
    return (a - b).squaredNorm() < limits_.squaredDistance(b.z(), height_of_b);
  }

  void close(int row, int begin, int end) {
    if (begin < 0) return;
    clusters_.add(row, begin, end, [&](int col) {
      const Eigen::Vector3f p = view_.point(row, col);
      return together(view_.point(row - 1, col), p, height(p));
    });
  }

  const BaseCloud& cloud_;
  const geometry::CloudView& view_;
  const Eigen::Vector3f up_;
  const float offset_;
  const ClusterLimits& limits_;
  RunForest& clusters_;
};

}  // namespace

ClusterLimits::ClusterLimits(const DetectionOptions& options, const SensorNoise& noise,
                             const BaseCloud& cloud)
    : low_m(static_cast<float>(
          std::max(options.cluster.min_height_m, options.noise.sigmas * noise.floor_stddev_m))),
      high_m(static_cast<float>(options.cluster.max_height_m)),
      distance_m(static_cast<float>(options.cluster.neighbor_distance_m)),
      spacing_per_m(static_cast<float>(options.noise.spacings * noise.spacing_per_m)),
      noise_per_m2(static_cast<float>(options.noise.sigmas * noise.depth_per_m2)),
      camera_height_m(static_cast<float>(cloud.camera().z())),
      region(options.region) {}

std::size_t findClusters(const BaseCloud& cloud, const ClusterLimits& limits, RunForest& clusters) {
  clusters.clear();
  RowCutter cutter(cloud, limits, clusters);
  std::size_t valid = 0;
  for (int row = 0; row < cloud.height(); ++row) valid += cutter.cut(row);
  clusters.finish();
  return valid;
}

}  // namespace mixed_palletizing::detection
