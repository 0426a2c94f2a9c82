// Separation of the top face from the rest of a cluster (thesis 3.2.2 "Top-plane separation", 4.1.3).
//
// A slice of the box through its side faces holds few points, a slice through the top many. Slices are taken
// from below the height upwards; the first that holds th_slice times the points of the reference slice is the
// lower end of the top, so that uneven tops are kept and side faces are not.
#pragma once

#include <optional>

#include <mixed_palletizing/detection/options.hpp>

#include "cluster_shape.hpp"
#include "grid_runs.hpp"
#include "height.hpp"

namespace mixed_palletizing::detection {

/// Heights that belong to the top [m].
struct TopBand {
  double low_m = 0.0;
  double high_m = 0.0;
};

/// Nothing when no slice stands out: the cluster has no level top. Depth and slices grow with level.stddev_m.
std::optional<TopBand> separateTop(const HeightProfile& profile, const TopLevel& level,
                                   const DetectionOptions& options);

/// Fills `pieces` with the connected pieces of the cluster's points inside the band and returns the index of
/// the largest one; nothing when the band is empty.
std::optional<std::size_t> findTopPiece(const BaseCloud& cloud, const RunRange& cluster, const TopBand& band,
                                        RunForest& pieces);

/// Mean and standard deviation of the heights of a top.
struct TopHeight {
  double mean_m = 0.0;
  double stddev_m = 0.0;
  std::size_t count = 0;
};

TopHeight measureHeight(const BaseCloud& cloud, const RunRange& top);

}  // namespace mixed_palletizing::detection
