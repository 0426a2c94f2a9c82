// The largest plane of a cloud by RANSAC (thesis 2.6.3, 3.2.1).
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/plane.hpp>

namespace mixed_palletizing::detection {

struct PlaneFit {
  geometry::Plane plane;  ///< camera frame, the normal points to the camera
  std::size_t inliers = 0;
  std::size_t valid = 0;    ///< points with data
  double distance_m = 0.0;  ///< inlier distance of the last round
  double rms_m = 0.0;       ///< of the inliers
};

/// A plane, or what was found instead.
struct PlaneResult {
  std::optional<PlaneFit> fit;
  std::string message;
};

/// Samples three points at a time from a seeded subset until eq. 3.4 grants the probability, then fits all
/// inliers of the whole cloud by least squares, round by round with an inlier distance that follows their
/// spread: a fine sensor sheds the feet of the boxes, a coarse one keeps its floor.
PlaneResult findLargestPlane(const geometry::CloudView& cloud, const PlaneOptions& options);

}  // namespace mixed_palletizing::detection
