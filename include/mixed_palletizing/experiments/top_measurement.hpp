// The variants of the thesis' separation of tops and of its formulas for sizes, against the truth.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/detection/top_study.hpp>
#include <mixed_palletizing/experiments/scene_measurement.hpp>

namespace mixed_palletizing::experiments {

/// One cluster and the box that it is.
struct TopRecord {
  std::uint64_t scene = 0;
  TrueBox truth;
  detection::TopStudy study;
  Eigen::Vector2d center_px = Eigen::Vector2d::Zero();    ///< true centre of the top, column and row
  Eigen::Vector2d centroid_px = Eigen::Vector2d::Zero();  ///< of the points of the first variant's top
};

/// Studies scene `index` in its true base frame: errors are those of the top alone. Clusters that are no box
/// are left out: their centroid lies more than half a width from every box that must be found.
std::vector<TopRecord> measureTops(const SceneSource& source, std::uint64_t index,
                                   const detection::DetectionOptions& options,
                                   const std::vector<double>& thresholds_m);

/// One line: `scene`, `truth` {size, top_center, visible_ratio, center_px}, `centroid_px`, `reference`
/// (points in a slice through the sides), `slices` [[upper end below the height in mm, points]] from 20 mm
/// below the height on, `variants` [{threshold_mm (0: adaptive), depth_mm (lower end below the height),
/// points, sides, edge_angle_deg, centroid_error_mm, center_error_mm, sizes {by_offsets, along_yaw,
/// smallest_sum: {length_mm, width_mm, yaw_deg}}}], errors as found minus true; `sizes` and `center_error_mm`
/// are null without edges on all four sides.
std::string topJson(const TopRecord& record);

}  // namespace mixed_palletizing::experiments
