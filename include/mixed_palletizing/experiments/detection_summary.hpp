// One row of a table from many measured scenes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <mixed_palletizing/experiments/scene_measurement.hpp>

namespace mixed_palletizing::experiments {

/// Of absolute values, except `bias` and `stddev`, which are of the signed ones.
struct ErrorStatistics {
  std::size_t count = 0;
  double mean = 0.0;
  double rms = 0.0;
  double median = 0.0;
  double p95 = 0.0;
  double worst = 0.0;
  double bias = 0.0;
  double stddev = 0.0;
};

ErrorStatistics statisticsOf(const std::vector<double>& errors);

/// Millimetres, degrees and milliseconds. Boxes that need not be found (TrueBox::counts) are left out except
/// where it says so. Position, yaw, length and width are those of boxes reported as complete
/// (BoxErrors::isComplete); of the others a size counts when its own standard deviation says that it is
/// known.
struct DetectionSummary {
  std::size_t scenes = 0;
  std::size_t boxes = 0;       ///< that must be found
  std::size_t found = 0;       ///< of them
  std::size_t invented = 0;    ///< detections that are no box
  std::size_t incomplete = 0;  ///< found, with a side of the top reported as not known
  ErrorStatistics position_mm;
  ErrorStatistics yaw_deg;
  ErrorStatistics side_mm;  ///< lengths and widths
  ErrorStatistics height_mm;
  std::array<double, kQuantityCount> within_2_stddev{};  ///< share of the errors, by quantity; complete boxes
  double coverage = 0.0;                                 ///< share of all those errors
  std::size_t confident_wrong_sizes = 0;  ///< BoxErrors::hasConfidentWrongSize, of every found box
  std::size_t sizes_beyond_stddev = 0;    ///< BoxErrors::hasSizeBeyondStddev, of every found box
  std::size_t truncated = 0;              ///< boxes partly outside the image
  std::size_t truncated_found = 0;        ///< of them
  std::size_t truncated_flagged = 0;      ///< of those found, with the flag
  std::size_t base_found = 0;             ///< scenes whose base frame was found
  ErrorStatistics base_origin_mm;         ///< horizontal
  ErrorStatistics base_height_mm;
  ErrorStatistics base_tilt_deg;
  ErrorStatistics base_yaw_deg;
  ErrorStatistics detect_ms;
  ErrorStatistics base_ms;
  std::uint64_t worst_scene =
      0;  ///< missed and invented boxes first, then confident wrong sizes, then position

  double recall() const;  ///< 1 without boxes
  double precision()
      const;  ///< 1 without detections; detections of boxes that need not be found do not count
};

DetectionSummary summarize(const std::vector<SceneRecord>& records);

/// Some lines for people.
std::string summaryText(const DetectionSummary& summary);

}  // namespace mixed_palletizing::experiments
