// Measured scenes as JSON, for the reports.
#pragma once

#include <string>

#include <mixed_palletizing/experiments/detection_summary.hpp>

namespace mixed_palletizing::experiments {

/// One line: `scene`, `base` {found, message, origin_mm, tilt_deg, yaw_deg}, `boxes` [{truth {top_center,
/// size, yaw, visible_ratio, measured_ratio, truncated, counts, corners_px}, found {top_center, size, yaw,
/// flags, corners_px}, errors {x.., each in mm or deg}, stddevs (likewise), camera_error_mm,
/// camera_turn_deg}] with found null for a missed box, `invented` [like found], `refusals`, `base_ms`,
/// `detect_ms`. Metres and radians where no unit is named.
std::string recordJson(const SceneRecord& record);

/// One object: every member of DetectionSummary by its name, statistics as {count, mean, rms, median, p95,
/// worst, bias, stddev}, and `recall`, `precision`.
std::string summaryJson(const DetectionSummary& summary);

}  // namespace mixed_palletizing::experiments
