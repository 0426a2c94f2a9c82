// Boxes in a stack, seen from above (mode depalletize).
#pragma once

#include <optional>
#include <vector>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/detection/work_region.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

#include "box_candidate.hpp"
#include "height_raster.hpp"
#include "part_fit.hpp"
#include "sensor_noise.hpp"
#include "top_segments.hpp"

namespace mixed_palletizing::detection {

/// Every fully visible top is a box, whatever it stands on. Keeps its buffers between calls.
class StackPipeline {
 public:
  /// The options must outlive the pipeline.
  explicit StackPipeline(const DetectionOptions& options);

  /// As BoxDetector::detect(), for a usable cloud and pose.
  Detections detect(const geometry::CloudView& cloud, const geometry::Pose& base_from_camera,
                    bool keep_stages);

 private:
  /// A box and its top's rectangle.
  struct Found {
    DetectedBox box;
    geometry::Rectangle footprint;
    int segment = -1;
  };

  void examineSegment(const BaseCloud& cloud, const SensorNoise& noise, int number, Detections& result);
  Found toBox(const BaseCloud& cloud, const SensorNoise& noise, int number, const PartFit& fit) const;
  std::optional<Refusal> judge(const PartFit& fit, const geometry::Rectangle& top) const;
  std::optional<Refusal> judgeSolid(const PartFit& fit, const Found& found) const;
  void reject(const Refusal& refusal, const geometry::Rectangle& top, double top_m, Detections& result) const;
  void label(const BaseCloud& cloud, Detections& result);
  void dropSparse(Detections& result);
  void doubtGaps();
  void flagTouching(Detections& result) const;
  void keepStages(const BaseCloud& cloud, Detections& result) const;

  const DetectionOptions& options_;
  WorkRegion region_;
  double step_m_ = 0.0;  // of this cloud
  geometry::Pose camera_from_base_ = geometry::Pose::Identity();
  HeightRaster raster_;
  TopSegments segments_;
  std::vector<Found> found_;
};

}  // namespace mixed_palletizing::detection
