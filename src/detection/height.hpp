// Height of the top face of a cluster (thesis 3.2.2 "Height calculation").
#pragma once

#include <optional>

#include <mixed_palletizing/detection/options.hpp>

#include "cluster_shape.hpp"
#include "sensor_noise.hpp"

namespace mixed_palletizing::detection {

/// Mean height [m] of the points whose horizontal distance from the cluster's centroid is at most the radius:
/// the thesis' patch. Nothing when there is no such point.
std::optional<double> patchHeight(const BaseCloud& cloud, const RunRange& cluster, const ClusterShape& shape,
                                  double radius_m);

/// A level that many points share.
struct TopLevel {
  double height_m = 0.0;
  double stddev_m = 0.0;      ///< of the heights around it
  double side_density = 0.0;  ///< points in a slice in the middle of the box: the thesis' reference slice
  double peak_density = 0.0;  ///< points in a slice at the level
};

/// Level of the top. The thesis' patch lies beside the top when the camera looks at the box from the side (the
/// centroid slides onto the edge), so the level is taken where the height profile is densest, and the patch
/// only decides between levels that are about as dense. `floor_m`: heights below it are no top.
TopLevel findTopLevel(const HeightProfile& profile, std::optional<double> patch_height_m, double floor_m,
                      double window_m);

}  // namespace mixed_palletizing::detection
