// The services of DetectorServer: calibrate and detect wait for clouds, and trigger the camera when they may.
#include <algorithm>
#include <exception>
#include <thread>

#include <ros/console.h>
#include <ros/init.h>
#include <ros/service.h>
#include <sensor_msgs/Image.h>
#include <std_srvs/Empty.h>

#include <mixed_palletizing/adapters/detector_server.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>

#include "calibration_service.hpp"

namespace mixed_palletizing::adapters {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongestTimeoutS = 3600.0;
constexpr std::chrono::milliseconds kConnectionPoll(10);

/// A capture whose cloud got lost is asked for again after this time, a camera that refused after this.
constexpr std::chrono::seconds kTriggerAgain(5);
constexpr std::chrono::seconds kRefusedAgain(1);

bool goodTimeout(double timeout_s) { return timeout_s >= 0.0 && timeout_s <= kLongestTimeoutS; }

}  // namespace

Arrival DetectorServer::awaitCloud(std::uint64_t sequence, double timeout_s, const ros::Time& not_before) {
  const auto wait = std::chrono::duration<double>(timeout_s > 0.0 ? timeout_s : options_.cloud_timeout_s);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(wait);
  for (;;) {
    auto patience = deadline;
    bool refused = false;
    if (!options_.capture_service.empty()) {
      refused = !triggerCamera(deadline);
      patience = std::min(deadline, Clock::now() + (refused ? kRefusedAgain : kTriggerAgain));
    }
    Arrival arrival = inbox_.waitAfter(sequence, patience);
    if (arrival.kind == Arrival::Kind::kTimeout) {
      if (Clock::now() < deadline) continue;
      arrival.dropped = refused ? cameraSilent() : silence();
    }
    const bool too_old = arrival.kind == Arrival::Kind::kCloud && arrival.stamp < not_before;
    if (!too_old) return arrival;
    sequence = arrival.sequence;
  }
}

bool DetectorServer::triggerCamera(Clock::time_point deadline) {
  // A camera driver publishes nothing as long as it sees no subscriber.
  while (points_.getNumPublishers() == 0 && Clock::now() < deadline && ros::ok()) {
    std::this_thread::sleep_for(kConnectionPoll);
  }
  const bool triggered = camera_.trigger(deadline) == CameraTrigger::Outcome::kTriggered;
  if (!triggered) ROS_WARN_STREAM(cameraSilent());
  return triggered;
}

bool DetectorServer::capture() const {
  std_srvs::Empty empty;  // the same on the wire as zivid_camera/Capture
  return ros::service::call(captureService(), empty);
}

std::string DetectorServer::cameraSilent() const {
  return "capture_service " + captureService() + " does not answer";
}

std::string DetectorServer::captureService() const {
  return siblingName(service_node_, options_.capture_service);
}

std::string DetectorServer::silence() const {
  if (points_.getNumPublishers() == 0) {
    return "nobody publishes on " + points_.getTopic() +
           "; rostopic list shows what there is, the launch argument points names the topic";
  }
  if (!options_.capture_service.empty()) return "";
  return "a camera that captures on request is triggered when capture_service names its service";
}

bool DetectorServer::onDetect(DetectBoxesRequest& request, DetectBoxesResponse& response) {
  try {
    detect(request, response);
  } catch (const std::exception& error) {
    response.status = DetectBoxesResponse::FAILED;
    response.message = error.what();
  }
  response.success = response.status == DetectBoxesResponse::OK ? 1 : 0;
  return true;
}

void DetectorServer::detect(const DetectBoxesRequest& request, DetectBoxesResponse& response) {
  if (!goodTimeout(request.timeout)) {
    response.status = DetectBoxesResponse::BAD_REQUEST;
    response.message = "timeout: " + std::to_string(request.timeout) + " s is not within 0 and 3600";
    return;
  }
  if (!base_frame_.calibrated()) {
    response.status = DetectBoxesResponse::NOT_CALIBRATED;
    response.message = "there is no base frame yet: call the service calibrate";
    return;
  }
  const std::uint64_t sequence = inbox_.sequence();
  Arrival arrival = inbox_.since(request.not_before, ros::Time::now());
  if (arrival.kind == Arrival::Kind::kTimeout)
    arrival = awaitCloud(sequence, request.timeout, request.not_before);
  if (arrival.kind != Arrival::Kind::kCloud) {
    const bool dropped = arrival.kind == Arrival::Kind::kDropped;
    response.status = dropped ? DetectBoxesResponse::BAD_CLOUD : DetectBoxesResponse::TIMEOUT;
    response.message = arrival.dropped;
    if (!dropped) {
      const std::string why = arrival.dropped.empty() ? "" : ": " + arrival.dropped;
      response.message = "no cloud came on " + points_.getTopic() + why;
      if (aheadOfTheClock(inbox_.latest()))
        response.message += "; the last one is stamped ahead of this computer's clock";
    }
    return;
  }
  const Processed processed = process(arrival.cloud);
  response.status = processed.status;
  response.message = processed.message;
  if (processed.boxes) response.boxes = *processed.boxes;
}

bool DetectorServer::onCalibrate(CalibrateRequest& request, CalibrateResponse& response) {
  try {
    calibrate(request, response);
  } catch (const std::exception& error) {
    response.status = CalibrateResponse::FAILED;
    response.message = error.what();
  }
  response.success = response.status == CalibrateResponse::OK ? 1 : 0;
  ROS_INFO_STREAM("calibration: " << response.message);
  return true;
}

void DetectorServer::calibrate(const CalibrateRequest& request, CalibrateResponse& response) {
  CalibrationRun run(options_, request);
  const std::unique_lock<std::mutex> lock(calibrating_, std::try_to_lock);
  if (!run.failed() && !lock.owns_lock())
    run.fail(CalibrateResponse::BUSY, "another calibration is under way");
  while (run.wantsCloud()) {
    const Arrival arrival = awaitCloud(inbox_.sequence(), request.timeout, ros::Time());
    run.add(arrival);
    if (arrival.kind == Arrival::Kind::kCloud) marker_image_.publish(run.markerImage(arrival.cloud));
  }
  run.finish(base_frame_);
  response = run.response();
}

}  // namespace mixed_palletizing::adapters
