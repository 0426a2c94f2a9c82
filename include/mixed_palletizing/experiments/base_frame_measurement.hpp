// The base frame from simulated views of markers and boards of markers, against the truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/experiments/detection_summary.hpp>

namespace mixed_palletizing::experiments {

/// What a view shows.
enum class MarkerKind {
  kNormal,    ///< one marker, black on white
  kInverted,  ///< one marker, white on black
  kBoard,     ///< a sheet of markers, normal or inverted, some of which may lie outside the image
};

/// "normal", "inverted", "board".
const char* toString(MarkerKind kind);

/// What the views are drawn from.
struct BaseFrameViews {
  double max_tilt_rad = 1.0471975511965976;  ///< of the optical axis against straight down
  double min_distance_m = 1.0;
  double max_distance_m = 2.0;
  double min_depth_stddev_at_1m_m = 0.0001;
  double max_depth_stddev_at_1m_m = 0.0003;
  int width_px = 1920;
  int height_px = 1200;
  /// One is drawn for every view, and an id of it.
  std::vector<std::string> dictionaries{"DICT_4X4_50", "DICT_5X5_100",        "DICT_6X6_250",
                                        "DICT_7X7_50", "DICT_ARUCO_ORIGINAL", "DICT_APRILTAG_36h11"};
};

struct BaseFrameRecord {
  std::uint64_t index = 0;
  MarkerKind kind = MarkerKind::kNormal;
  std::string dictionary;
  double tilt_rad = 0.0;
  double distance_m = 0.0;  ///< of the camera from the marker's centre
  bool found = false;
  std::string message;  ///< why it was not found
  BaseFrameErrors errors;
  double rotation_rad = 0.0;  ///< angle between the true and the found frame
  double milliseconds = 0.0;

  double position_m() const { return errors.origin_m.norm(); }
};

/// View `index`; every third is of one kind. The same for the same arguments. Throws std::invalid_argument for views
/// that cannot be drawn: sizes or distances that are not positive, no dictionary, a tilt of a right angle or more.
BaseFrameRecord measureBaseFrame(const BaseFrameViews& views, std::uint64_t seed, std::uint64_t index);

/// The records of one kind.
struct BaseFrameSummary {
  std::size_t views = 0;
  std::size_t found = 0;
  ErrorStatistics position_mm;   ///< of the origin, in space
  ErrorStatistics rotation_deg;  ///< about any axis
  ErrorStatistics yaw_deg;
  ErrorStatistics milliseconds;
};

BaseFrameSummary summarize(const std::vector<BaseFrameRecord>& records, MarkerKind kind);

/// One line for people: name, found, and mean, RMS, 95 % and worst of position and rotation.
std::string summaryText(const std::string& name, const BaseFrameSummary& summary);

/// One line: `view`, `kind`, `dictionary`, `tilt_deg`, `distance_m`, `found`, `message`, `position_mm`,
/// `rotation_deg`, `yaw_deg`, `ms`.
std::string recordJson(const BaseFrameRecord& record);

}  // namespace mixed_palletizing::experiments
