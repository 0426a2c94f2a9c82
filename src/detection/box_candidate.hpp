// From one cluster to one box, or to the reason why it is none.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

#include "cluster_shape.hpp"
#include "outline.hpp"
#include "outline_match.hpp"
#include "rectangle_fit.hpp"
#include "sensor_noise.hpp"
#include "stage_clock.hpp"
#include "top_plane.hpp"

namespace mixed_palletizing::detection {

/// A box together with what the pipeline still needs of it.
struct FoundBox {
  DetectedBox box;
  geometry::Rectangle footprint;
  double top_m = 0.0;     ///< upper end of the top's band
  double bottom_m = 0.0;  ///< what the box stands on
};

/// Why it is no box.
struct Refusal {
  RejectReason reason;
  std::string text;
};

/// Runs the stages after the clusters; keeps its buffers between calls.
class BoxCandidate {
 public:
  /// The options must outlive this object.
  explicit BoxCandidate(const DetectionOptions& options) : options_(options) {}

  /// `shape` is measured from `cluster`. Adds the time of its stages to the clock.
  std::variant<FoundBox, Refusal> examine(const BaseCloud& cloud, const geometry::Pose& base_from_camera,
                                          const SensorNoise& noise, double floor_m, const RunRange& cluster,
                                          const ClusterShape& shape, StageClock& clock);

  /// Of the last examined cluster, as far as it came: pixels of the top and of its outline.
  const RunRange& top() const { return top_; }
  const std::vector<OutlineSample>& outline() const { return outline_; }

 private:
  struct Context;
  std::optional<Refusal> findTop(const Context& context);
  std::variant<RectangleFit, Refusal> findRectangle(const Context& context, StageClock& clock);
  std::optional<Refusal> judge(const Context& context, const RectangleFit& fit);
  FoundBox describe(const Context& context, const RectangleFit& fit) const;

  const DetectionOptions& options_;
  RunForest pieces_;
  OutlineTracer tracer_;
  std::vector<OutlineSample> outline_;
  std::vector<Eigen::Vector2d> points_;
  RunRange top_;
  TopBand band_;
  TopHeight height_;
  OutlineMatch match_;
  double hull_area_ = 0.0;
};

}  // namespace mixed_palletizing::detection
