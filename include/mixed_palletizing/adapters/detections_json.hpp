// Detections as JSON.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::adapters {

/// Names of the set bits of DetectedBox::flags, as in Box.msg.
std::vector<std::string> flagNames(std::uint8_t flags);

/// One object: `base_from_camera` (4 x 4, rows), `cloud` {width, height, valid_ratio}, `boxes` [{id, center,
/// top_center, yaw, size [l, w, h], size_stddev, pose_covariance (6 x 6, rows), top_visibility, point_count,
/// flags [names]}], `rejected` [{reason, text, centroid, extent}], `timings_ms` {stages..., total}. Metres and
/// radians in the base frame; numbers that are not finite become null.
std::string detectionsJson(const geometry::Pose& base_from_camera, const detection::Detections& detections,
                           double total_ms);

}  // namespace mixed_palletizing::adapters
