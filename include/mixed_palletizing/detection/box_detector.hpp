// The detection chain of thesis 3.2.2 and 3.2.3 over one organized cloud.
#pragma once

#include <memory>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {

/// Finds boxes above the floor of the base frame. Keeps its buffers between calls, so one instance serves one
/// thread at a time; two instances are independent.
class BoxDetector {
 public:
  /// Throws std::invalid_argument with every line of problems(options).
  explicit BoxDetector(const DetectionOptions& options);
  ~BoxDetector();
  BoxDetector(BoxDetector&&) noexcept;
  BoxDetector& operator=(BoxDetector&&) noexcept;

  /// Boxes of one cloud in the base frame. The cloud is read in place, once for the clusters; points that are
  /// not finite are skipped. `keep_stages` fills Detections::stage_pixels for debugging. Throws
  /// std::invalid_argument for a view without data or size.
  Detections detect(const geometry::CloudView& cloud, const geometry::Pose& base_from_camera,
                    bool keep_stages = false);

  const DetectionOptions& options() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mixed_palletizing::detection
