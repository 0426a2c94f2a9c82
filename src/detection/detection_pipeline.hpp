// What BoxDetector runs: one of the methods.
#pragma once

#include <memory>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {

class DetectionPipeline {
 public:
  virtual ~DetectionPipeline() = default;

  /// As BoxDetector::detect(), for a usable cloud and pose.
  virtual Detections detect(const geometry::CloudView& cloud, const geometry::Pose& base_from_camera,
                            bool keep_stages) = 0;
};

/// The chain of chapter 3.2 of the source thesis (thesis_pipeline.cpp). The options must outlive the pipeline.
std::unique_ptr<DetectionPipeline> makeThesisPipeline(const DetectionOptions& options);

/// Level pieces, explained by rectangles (level_pipeline.cpp).
std::unique_ptr<DetectionPipeline> makeLevelPipeline(const DetectionOptions& options);

}  // namespace mixed_palletizing::detection
