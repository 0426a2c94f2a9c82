// Thresholds that can be turned while the node runs (dynamic_reconfigure, rqt_reconfigure).
#pragma once

#include <functional>
#include <memory>

#include <ros/node_handle.h>

#include <mixed_palletizing/DetectionConfig.h>
#include <mixed_palletizing/detection/options.hpp>

namespace mixed_palletizing::adapters {

/// The values of `options` that can be turned.
DetectionConfig toConfig(const detection::DetectionOptions& options);

/// `options` with the values of `config`; what cannot be turned stays.
detection::DetectionOptions withConfig(detection::DetectionOptions options, const DetectionConfig& config);

/// Serves the group of parameters `~tuning`. Thread safe.
class DetectionTuning {
 public:
  using Apply = std::function<void(const detection::DetectionOptions&)>;

  /// Starts from `options`, whatever an earlier run left on the parameter server. A change that makes a usable set of
  /// options goes to `apply`; any other is taken back with a warning, and `~tuning/answer` says why.
  DetectionTuning(const ros::NodeHandle& node, const detection::DetectionOptions& options, Apply apply);
  ~DetectionTuning();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mixed_palletizing::adapters
