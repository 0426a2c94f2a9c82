// What /diagnostics says about the detector.
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>

#include <mixed_palletizing/adapters/base_frame_keeper.hpp>
#include <mixed_palletizing/adapters/fault_counter.hpp>
#include <mixed_palletizing/detection/detections.hpp>

namespace mixed_palletizing::adapters {

/// Thread safe.
class DetectorDiagnostics {
 public:
  DetectorDiagnostics(const ros::NodeHandle& private_node, const FaultCounter& drops,
                      const BaseFrameKeeper& base_frame);

  void cloudArrived(const std::string& camera_frame);
  void cloudDropped();
  void detected(const detection::Detections& detections, double processing_ms);

  /// Publishes; to be called now and then.
  void update();

 private:
  using Clock = std::chrono::steady_clock;
  void reportClouds(diagnostic_updater::DiagnosticStatusWrapper& status);
  void reportBaseFrame(diagnostic_updater::DiagnosticStatusWrapper& status);

  const FaultCounter& drops_;
  const BaseFrameKeeper& base_frame_;
  std::mutex mutex_;
  std::optional<Clock::time_point> last_cloud_;
  bool last_was_dropped_ = false;
  std::string camera_frame_;
  std::uint64_t accepted_ = 0;
  std::uint64_t detections_ = 0;
  double valid_ratio_ = 0.0;
  std::size_t boxes_ = 0;
  std::map<std::string, std::uint64_t> rejected_;  // in all clouds, by reason
  std::vector<detection::StageTime> stage_times_;
  double processing_ms_ = 0.0;
  diagnostic_updater::Updater updater_;  // last: its tasks use the members above
};

}  // namespace mixed_palletizing::adapters
