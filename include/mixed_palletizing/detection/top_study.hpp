// The thesis' chain opened up: what its separation of the top, edges and formulas for sizes give side by side
// (thesis 3.2.2, 3.2.3, 4.1.3, 4.1.5, 4.1.7). For experiments; the detector does not use it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/pose.hpp>
#include <mixed_palletizing/geometry/rectangle.hpp>

namespace mixed_palletizing::detection {

/// The rectangle of four edges by the thesis' formulas; they share the centre. Length first.
struct EdgeSizes {
  geometry::Rectangle by_offsets;  ///< eq. 3.11: difference of the lines' distances from the origin
  geometry::Rectangle along_yaw;   ///< eq. 4.1, 4.2: measured along the yaw through the centre
  geometry::Rectangle
      smallest_sum;  ///< the yaw near the edges' for which width and length of eq. 4.2 add up to the least
};

/// One way to separate the top from its cluster and what follows from it.
struct TopVariant {
  double threshold_m = 0.0;  ///< largest distance from the height; 0: adaptive by slices
  double low_m = 0.0;        ///< lower end of what belongs to the top
  std::size_t points = 0;
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  ///< of the top's points
  int sides = 0;                                       ///< that have an edge
  double edge_angle_rad = 0.0;     ///< largest angle between edges that should be parallel
  std::optional<EdgeSizes> sizes;  ///< with edges on all four sides
};

/// One cluster.
struct TopStudy {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the cluster
  double height_m = 0.0;                               ///< level of the top
  double slice_m = 0.0;
  std::vector<std::uint32_t> slices;  ///< points by height: slice i holds heights in [i, i + 1) * slice_m
  double reference = 0.0;             ///< points in a slice through the sides
  std::vector<TopVariant>
      variants;  ///< adaptive, then one for each threshold; those without a top are left out
};

/// Every cluster of the cloud that is large enough and has a level top. `thresholds_m` are tried beside the
/// adaptive separation. Throws std::invalid_argument with the lines of problems(options).
std::vector<TopStudy> studyTops(const geometry::CloudView& cloud, const geometry::Pose& base_from_camera,
                                const DetectionOptions& options, const std::vector<double>& thresholds_m);

}  // namespace mixed_palletizing::detection
