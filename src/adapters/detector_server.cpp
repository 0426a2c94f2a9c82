#include <algorithm>
#include <exception>

#include <ros/console.h>
#include <ros/service.h>
#include <sensor_msgs/Image.h>
#include <std_srvs/Empty.h>

#include <mixed_palletizing/adapters/box_messages.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/adapters/detector_server.hpp>
#include <mixed_palletizing/adapters/names.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>

#include "calibration_service.hpp"
#include "detector_diagnostics.hpp"
#include "detector_outputs.hpp"

namespace mixed_palletizing::adapters {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kWarningInterval(5);
constexpr double kDiagnosticsPeriodS = 1.0;
constexpr double kLongestTimeoutS = 3600.0;
constexpr std::uint32_t kServiceThreads = 4;  // that many callers can wait for clouds at a time

ros::NodeHandle onQueue(ros::NodeHandle node, ros::CallbackQueue* queue) {
  node.setCallbackQueue(queue);
  return node;
}

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

bool goodTimeout(double timeout_s) { return timeout_s >= 0.0 && timeout_s <= kLongestTimeoutS; }

}  // namespace

DetectorServer::DetectorServer(const ros::NodeHandle& private_node)
    : options_(readDetectorOptions(parameterTree(private_node))),
      cloud_node_(onQueue(private_node, &cloud_queue_)),
      service_node_(onQueue(private_node, &service_queue_)),
      drops_([](const std::string& line) { ROS_WARN_STREAM("cloud dropped: " << line); }, kWarningInterval),
      base_frame_(options_),
      outputs_(std::make_unique<DetectorOutputs>(service_node_)),
      diagnostics_(std::make_unique<DetectorDiagnostics>(service_node_, drops_, base_frame_)),
      detector_(options_.detection),
      cloud_spinner_(1, &cloud_queue_),
      service_spinner_(kServiceThreads, &service_queue_) {
  marker_image_ = service_node_.advertise<sensor_msgs::Image>(names::kMarkerImage, 1);
  points_ =
      cloud_node_.subscribe(siblingName(private_node, names::kPoints), 1, &DetectorServer::onCloud, this);
  detect_service_ = service_node_.advertiseService(names::kDetect, &DetectorServer::onDetect, this);
  calibrate_service_ = service_node_.advertiseService(names::kCalibrate, &DetectorServer::onCalibrate, this);
  diagnostics_timer_ =
      service_node_.createSteadyTimer(ros::WallDuration(kDiagnosticsPeriodS),
                                      [this](const ros::SteadyTimerEvent&) { diagnostics_->update(); });
  cloud_spinner_.start();
  service_spinner_.start();
  ROS_INFO_STREAM("clouds from " << points_.getTopic() << ", base frame '" << options_.base_frame
                                 << "': " << base_frame_.description());
}

DetectorServer::~DetectorServer() {
  inbox_.close();
  points_.shutdown();
  service_spinner_.stop();
  cloud_spinner_.stop();
}

void DetectorServer::onCloud(const sensor_msgs::PointCloud2ConstPtr& message) {
  try {
    const CheckedCloud checked = checkCloud(*message);
    if (!checked.view) {
      drops_.count(toString(checked.fault), checked.message);
      diagnostics_->cloudDropped();
      inbox_.drop(std::string(toString(checked.fault)) + ": " + checked.message, message->header.stamp);
      return;
    }
    diagnostics_->cloudArrived(message->header.frame_id);
    AcceptedCloud cloud;
    cloud.message = message;
    cloud.view = *checked.view;
    cloud.sequence = inbox_.accept(cloud);
    if (options_.calibrate_on_start && !base_frame_.calibrated()) calibrateWith(cloud);
    if (outputs_->wanted()) process(cloud);
  } catch (const std::exception& error) {
    drops_.count("fault", error.what());
  }
}

DetectorServer::Processed DetectorServer::process(const AcceptedCloud& cloud) {
  std::lock_guard<std::mutex> lock(processing_);
  // A waiting service and the subscriber come with the same cloud: the second finds the work done.
  if (processed_.boxes && processed_sequence_ == cloud.sequence) return processed_;
  Processed result;
  try {
    result = detectIn(cloud);
  } catch (const std::exception& error) {
    result.status = DetectBoxesResponse::FAILED;
    result.message = error.what();
    drops_.count("fault", error.what());
  }
  processed_sequence_ = cloud.sequence;
  processed_ = result;
  return result;
}

DetectorServer::Processed DetectorServer::detectIn(const AcceptedCloud& cloud) {
  const Clock::time_point start = Clock::now();
  Processed result;
  const std_msgs::Header& header = cloud.message->header;
  const BaseFrameAnswer base = base_frame_.find(header.frame_id, header.stamp);
  if (!base.base_from_camera) {
    drops_.count(base.reason, base.message);
    result.status = DetectBoxesResponse::NOT_CALIBRATED;
    result.message = base.reason + ": " + base.message;
    return result;
  }
  const detection::Detections detections =
      detector_.detect(cloud.view, *base.base_from_camera, outputs_->stagesWanted());
  const double processing_ms = millisecondsSince(start);
  std_msgs::Header base_header = header;
  base_header.frame_id = options_.base_frame;
  result.boxes = toMessage(detections, base_header, processing_ms);
  result.message = std::to_string(detections.boxes.size()) + " boxes";
  outputs_->publish(cloud, detections, result.boxes);
  diagnostics_->detected(detections, processing_ms);
  return result;
}

Arrival DetectorServer::awaitCloud(std::uint64_t sequence, double timeout_s, const ros::Time& not_before) {
  const auto wait = std::chrono::duration<double>(timeout_s > 0.0 ? timeout_s : options_.cloud_timeout_s);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(wait);
  if (!options_.capture_service.empty()) {
    std_srvs::Empty capture;  // the same on the wire as zivid_camera/Capture
    if (!ros::service::call(siblingName(service_node_, options_.capture_service), capture)) {
      ROS_WARN_STREAM("capture_service " << options_.capture_service << " does not answer");
    }
  }
  for (;;) {
    Arrival arrival = inbox_.waitAfter(sequence, deadline);
    const bool too_old = arrival.kind == Arrival::Kind::kCloud && arrival.stamp < not_before;
    if (!too_old) return arrival;
    sequence = arrival.sequence;
  }
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
  Arrival arrival = inbox_.latest();
  const bool came_before =
      arrival.sequence > 0 && !request.not_before.isZero() && arrival.stamp >= request.not_before;
  if (!came_before) arrival = awaitCloud(arrival.sequence, request.timeout, request.not_before);
  if (arrival.kind != Arrival::Kind::kCloud) {
    const bool dropped = arrival.kind == Arrival::Kind::kDropped;
    response.status = dropped ? DetectBoxesResponse::BAD_CLOUD : DetectBoxesResponse::TIMEOUT;
    response.message = dropped ? arrival.dropped : "no cloud came on " + points_.getTopic();
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
    if (marker_image_.getNumSubscribers() > 0 && arrival.kind == Arrival::Kind::kCloud) {
      marker_image_.publish(run.markerImage(arrival.cloud));
    }
  }
  run.finish(base_frame_);
  response = run.response();
}

void DetectorServer::calibrateWith(const AcceptedCloud& cloud) {
  const std::unique_lock<std::mutex> lock(calibrating_, std::try_to_lock);
  if (!lock.owns_lock()) return;  // the service is at it
  if (!first_calibration_)
    first_calibration_ = std::make_unique<CalibrationRun>(options_, CalibrateRequest());
  Arrival arrival;
  arrival.kind = Arrival::Kind::kCloud;
  arrival.cloud = cloud;
  first_calibration_->add(arrival);
  if (first_calibration_->wantsCloud()) return;
  // After a failure the next cloud begins anew.
  const std::unique_ptr<CalibrationRun> run = std::move(first_calibration_);
  run->finish(base_frame_);
  if (run->failed()) {
    drops_.count("not_calibrated", run->response().message);
  } else {
    ROS_INFO_STREAM("calibration with the first clouds: " << run->response().message);
  }
}

}  // namespace mixed_palletizing::adapters
