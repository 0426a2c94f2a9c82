// One call of the service calibrate: clouds in, the mean base frame out.
#pragma once

#include <string>
#include <vector>

#include <sensor_msgs/Image.h>

#include <mixed_palletizing/Calibrate.h>
#include <mixed_palletizing/adapters/base_frame_keeper.hpp>
#include <mixed_palletizing/adapters/cloud_inbox.hpp>
#include <mixed_palletizing/adapters/detector_options.hpp>
#include <mixed_palletizing/detection/base_frame.hpp>

namespace mixed_palletizing::adapters {

/// Collects the frames of the clouds and makes the response.
class CalibrationRun {
 public:
  CalibrationRun(const DetectorOptions& options, const CalibrateRequest& request);

  const CalibrateResponse& response() const { return response_; }

  /// The request was refused, or a cloud failed; the response says why.
  bool failed() const { return failed_; }
  void fail(std::uint8_t status, const std::string& message);

  /// More clouds are needed, and none failed.
  bool wantsCloud() const { return !failed_ && frames_.size() < wanted_; }
  void add(const Arrival& arrival);

  /// The cloud's picture with the markers that were seen in it, BGR8.
  sensor_msgs::ImagePtr markerImage(const AcceptedCloud& cloud) const;

  /// Puts the mean frame into use unless something failed. Throws what BaseFrameKeeper::set() throws.
  void finish(BaseFrameKeeper& keeper);

 private:
  const DetectorOptions& options_;
  CalibrateResponse response_;
  bool failed_ = false;
  std::size_t wanted_ = 0;
  std::string camera_frame_;
  std::vector<detection::BaseFrame> frames_;
};

}  // namespace mixed_palletizing::adapters
