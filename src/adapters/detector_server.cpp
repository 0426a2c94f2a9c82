#include <algorithm>
#include <exception>

#include <ros/console.h>
#include <sensor_msgs/Image.h>

#include <mixed_palletizing/adapters/box_messages.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/adapters/detection_tuning.hpp>
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
constexpr int kTicksToPublish = 4;            // of that period: for the camera's driver to come up
constexpr std::uint32_t kServiceThreads = 4;  // that many callers can wait for clouds at a time

ros::NodeHandle onQueue(ros::NodeHandle node, ros::CallbackQueue* queue) {
  node.setCallbackQueue(queue);
  return node;
}

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

DetectorServer::DetectorServer(const ros::NodeHandle& private_node)
    : options_(readDetectorOptions(parameterTree(private_node))),
      cloud_node_(onQueue(private_node, &cloud_queue_)),
      service_node_(onQueue(private_node, &service_queue_)),
      diagnostics_node_(onQueue(private_node, &diagnostics_queue_)),
      drops_([](const std::string& line) { ROS_WARN_STREAM("cloud dropped: " << line); }, kWarningInterval),
      camera_([this] { return capture(); }),
      base_frame_(options_),
      outputs_(std::make_unique<DetectorOutputs>(service_node_)),
      diagnostics_(std::make_unique<DetectorDiagnostics>(service_node_, drops_, base_frame_)),
      detection_options_(options_.detection),
      detector_(options_.detection),
      cloud_spinner_(1, &cloud_queue_),
      service_spinner_(kServiceThreads, &service_queue_),
      diagnostics_spinner_(1, &diagnostics_queue_) {
  marker_image_ = service_node_.advertise<sensor_msgs::Image>(names::kMarkerImage, 1, true);
  points_ =
      cloud_node_.subscribe(siblingName(private_node, names::kPoints),
                            static_cast<std::uint32_t>(options_.queue_size), &DetectorServer::onCloud, this);
  detect_service_ = service_node_.advertiseService(names::kDetect, &DetectorServer::onDetect, this);
  calibrate_service_ = service_node_.advertiseService(names::kCalibrate, &DetectorServer::onCalibrate, this);
  diagnostics_timer_ = diagnostics_node_.createSteadyTimer(
      ros::WallDuration(kDiagnosticsPeriodS), [this](const ros::SteadyTimerEvent&) { reportDiagnostics(); });
  tuning_ = std::make_unique<DetectionTuning>(
      onQueue(ros::NodeHandle(private_node, names::kTuning), &service_queue_), options_.detection,
      [this](const detection::DetectionOptions& options) { useOptions(options); });
  cloud_spinner_.start();
  service_spinner_.start();
  diagnostics_spinner_.start();
  ROS_INFO_STREAM("clouds from " << points_.getTopic() << ", base frame '" << options_.base_frame
                                 << "': " << base_frame_.description());
}

DetectorServer::~DetectorServer() {
  inbox_.close();
  points_.shutdown();
  diagnostics_spinner_.stop();
  service_spinner_.stop();
  cloud_spinner_.stop();
}

void DetectorServer::warnWithoutPublisher() {
  ticks_without_publisher_ = points_.getNumPublishers() == 0 ? ticks_without_publisher_ + 1 : 0;
  if (ticks_without_publisher_ == kTicksToPublish) ROS_WARN_STREAM("no cloud yet: " << silence());
}

void DetectorServer::onCloud(const sensor_msgs::PointCloud2ConstPtr& message) {
  try {
    const CheckedCloud checked = checkCloud(*message);
    if (!checked.view) {
      drops_.count(toString(checked.fault), checked.message);
      diagnostics_->cloudDropped();
      inbox_.drop(std::string(toString(checked.fault)) + ": " + checked.message, message->header.stamp,
                  ros::Time::now());
      return;
    }
    diagnostics_->cloudArrived(message->header.frame_id);
    AcceptedCloud cloud;
    cloud.message = message;
    cloud.view = *checked.view;
    cloud.sequence = inbox_.accept(cloud, ros::Time::now());
    if (options_.calibrate_on_start && !base_frame_.calibrated()) calibrateWith(cloud);
    if (outputs_->wanted() && !isForCalibration()) process(cloud);
  } catch (const std::exception& error) {
    countFault(error);
  }
}

/// Out of memory it may be that even this cannot be told.
void DetectorServer::countFault(const std::exception& fault) noexcept {
  try {
    drops_.count("fault", fault.what());
  } catch (const std::exception&) {
  }
}

void DetectorServer::reportDiagnostics() {
  try {
    diagnostics_->update();
    warnWithoutPublisher();
  } catch (const std::exception& error) {
    countFault(error);
  }
}

bool DetectorServer::isForCalibration() {
  return !base_frame_.calibrated() &&
         !std::unique_lock<std::mutex>(calibrating_, std::try_to_lock).owns_lock();
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
    countFault(error);
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
  if (base.revision != detector_revision_) renewDetector(base.revision);
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

void DetectorServer::useOptions(const detection::DetectionOptions& options) {
  std::lock_guard<std::mutex> lock(processing_);
  detection_options_ = options;
  renewDetector(detector_revision_);
  processed_.boxes.reset();
}

void DetectorServer::renewDetector(std::uint64_t revision) {
  detection::DetectionOptions options = detection_options_;
  const std::vector<geometry::Plane> removed = base_frame_.removedPlanes();
  options.region.planes.insert(options.region.planes.end(), removed.begin(), removed.end());
  detector_ = detection::BoxDetector(options);
  detector_revision_ = revision;
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
  marker_image_.publish(first_calibration_->markerImage(cloud));
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
