// The largest planes of a cloud by RANSAC (thesis 2.6.3, 3.2.1).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/plane.hpp>

namespace mixed_palletizing::detection {

struct PlaneFit {
  geometry::Plane plane;  ///< camera frame, the normal points to the camera
  std::size_t inliers = 0;
  std::size_t valid = 0;                               ///< points with data
  double distance_m = 0.0;                             ///< inlier distance of the last round
  double rms_m = 0.0;                                  ///< of the inliers
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the inliers, camera frame [m]
};

/// Planes, the largest first, or what was found instead.
struct PlanesResult {
  std::vector<PlaneFit> fits;
  std::string message;  ///< when there is none
};

/// Up to options.max_planes planes, each among the points that those before it left. Samples three points at a time from a seeded subset until eq. 3.4 grants the probability, then fits all
/// inliers of the whole cloud by least squares, round by round with an inlier distance that follows their
/// spread: a fine sensor sheds the feet of the boxes, a coarse one keeps its floor.
PlanesResult findPlanes(const geometry::CloudView& cloud, const PlaneOptions& options);

}  // namespace mixed_palletizing::detection
