#include "detector_diagnostics.hpp"

namespace mixed_palletizing::adapters {

using diagnostic_msgs::DiagnosticStatus;

DetectorDiagnostics::DetectorDiagnostics(const ros::NodeHandle& private_node, const FaultCounter& drops,
                                         const BaseFrameKeeper& base_frame)
    : drops_(drops),
      base_frame_(base_frame),
      updater_(private_node, private_node, private_node.getNamespace()) {
  updater_.setHardwareID("none");
  updater_.add("clouds", this, &DetectorDiagnostics::reportClouds);
  updater_.add("base frame", this, &DetectorDiagnostics::reportBaseFrame);
}

void DetectorDiagnostics::cloudArrived(const std::string& camera_frame) {
  std::lock_guard<std::mutex> lock(mutex_);
  last_cloud_ = Clock::now();
  last_was_dropped_ = false;
  camera_frame_ = camera_frame;
  ++accepted_;
}

void DetectorDiagnostics::cloudDropped() {
  std::lock_guard<std::mutex> lock(mutex_);
  last_cloud_ = Clock::now();
  last_was_dropped_ = true;
}

void DetectorDiagnostics::detected(const detection::Detections& detections, double processing_ms) {
  std::lock_guard<std::mutex> lock(mutex_);
  ++detections_;
  valid_ratio_ = detections.valid_ratio;
  boxes_ = detections.boxes.size();
  for (const auto& cluster : detections.rejected) ++rejected_[detection::toString(cluster.reason)];
  stage_times_ = detections.stage_times;
  processing_ms_ = processing_ms;
}

void DetectorDiagnostics::update() { updater_.force_update(); }

void DetectorDiagnostics::reportClouds(diagnostic_updater::DiagnosticStatusWrapper& status) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (!last_cloud_) {
    status.summary(DiagnosticStatus::OK, "no cloud yet");
  } else if (last_was_dropped_) {
    status.summary(DiagnosticStatus::WARN, "the last cloud was dropped");
  } else {
    status.summary(DiagnosticStatus::OK, "clouds are good");
  }
  if (last_cloud_) {
    const std::chrono::duration<double> age = Clock::now() - *last_cloud_;
    status.addf("age of the last cloud [s]", "%.1f", age.count());
    status.add("camera frame", camera_frame_);
  }
  status.add("clouds accepted", accepted_);
  status.add("clouds dropped", drops_.total());
  for (const auto& [reason, count] : drops_.counts()) status.add("dropped: " + reason, count);
  if (detections_ == 0) return;
  status.add("detections", detections_);
  status.addf("valid share of the points", "%.3f", valid_ratio_);
  status.add("boxes in the last cloud", boxes_);
  for (const auto& [reason, count] : rejected_) status.add("clusters rejected: " + reason, count);
  for (const auto& stage : stage_times_) {
    status.addf(std::string("time of ") + stage.stage + " [ms]", "%.1f", stage.milliseconds);
  }
  status.addf("time in all [ms]", "%.1f", processing_ms_);
}

void DetectorDiagnostics::reportBaseFrame(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const bool calibrated = base_frame_.calibrated();
  status.summary(calibrated ? DiagnosticStatus::OK : DiagnosticStatus::WARN, base_frame_.description());
}

}  // namespace mixed_palletizing::adapters
