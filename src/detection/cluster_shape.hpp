// Size, place and height profile of one cluster.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "base_cloud.hpp"
#include "grid_runs.hpp"

namespace mixed_palletizing::detection {

/// Points of the cluster by height: slice i holds heights in [i, i + 1) * slice_m.
struct HeightProfile {
  double slice_m = 0.001;
  std::vector<std::uint32_t> counts;

  /// Points between two heights [m]; slices that are cut count by their share.
  double between(double low_m, double high_m) const;
};

struct ClusterShape {
  std::size_t count = 0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< base frame [m]
  Eigen::Vector3d low = Eigen::Vector3d::Zero();       ///< corners of the axis-aligned bounds
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  HeightProfile profile;

  Eigen::Vector3d extent() const { return high - low; }
};

/// One pass over the cluster; reuses the memory of `shape`.
void measureShape(const BaseCloud& cloud, const RunRange& cluster, double slice_m, ClusterShape& shape);

}  // namespace mixed_palletizing::detection
