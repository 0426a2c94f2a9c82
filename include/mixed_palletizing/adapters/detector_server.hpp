// The detector at the ROS border: clouds in, boxes out, calibration and triggered detection as services.
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <string>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <sensor_msgs/PointCloud2.h>

#include <mixed_palletizing/BoxArray.h>
#include <mixed_palletizing/Calibrate.h>
#include <mixed_palletizing/DetectBoxes.h>
#include <mixed_palletizing/adapters/base_frame_keeper.hpp>
#include <mixed_palletizing/adapters/camera_trigger.hpp>
#include <mixed_palletizing/adapters/cloud_inbox.hpp>
#include <mixed_palletizing/adapters/detector_options.hpp>
#include <mixed_palletizing/adapters/fault_counter.hpp>
#include <mixed_palletizing/detection/box_detector.hpp>

namespace mixed_palletizing::adapters {

class CalibrationRun;
class DetectionTuning;
class DetectorOutputs;
class DetectorDiagnostics;

/// Topics and services of the detector (see docs/ros_api.md). Has threads of its own, one for clouds, some
/// for services that wait and one for diagnostics, so that none blocks the others or a nodelet manager. No callback lets an
/// exception out.
class DetectorServer {
 public:
  /// Parameters and services are private to `private_node`, topics lie in the namespace around it. Throws
  /// std::invalid_argument with all wrong parameters, std::runtime_error when a calibration that is needed
  /// cannot be read.
  explicit DetectorServer(const ros::NodeHandle& private_node);
  ~DetectorServer();

 private:
  /// The boxes of a cloud, or why there are none.
  struct Processed {
    BoxArrayConstPtr boxes;
    std::uint8_t status = DetectBoxesResponse::OK;
    std::string message;
  };

  void onCloud(const sensor_msgs::PointCloud2ConstPtr& message);
  bool onDetect(DetectBoxesRequest& request, DetectBoxesResponse& response);
  bool onCalibrate(CalibrateRequest& request, CalibrateResponse& response);
  void detect(const DetectBoxesRequest& request, DetectBoxesResponse& response);
  void calibrate(const CalibrateRequest& request, CalibrateResponse& response);

  /// One of the first clouds, when nobody calibrated yet and the node may do so itself.
  void calibrateWith(const AcceptedCloud& cloud);

  /// The callbacks throw nothing: whoever called them would end the whole process.
  void countFault(const std::exception& fault) noexcept;
  void reportDiagnostics();
  /// The first calibration is under way: its clouds are not missed for want of a base frame.
  bool isForCalibration();

  Processed process(const AcceptedCloud& cloud);
  Processed detectIn(const AcceptedCloud& cloud);
  /// Options changed while running: from the next cloud on.
  void useOptions(const detection::DetectionOptions& options);
  /// The detector for the options and for the planes that a new calibration removes. With processing_ locked.
  void renewDetector(std::uint64_t revision);
  /// The next cloud after arrival `sequence` that is not older than `not_before`; triggers the camera when its
  /// capture service is known.
  Arrival awaitCloud(std::uint64_t sequence, double timeout_s, const ros::Time& not_before);
  /// Why no cloud may be coming: for people; empty when nothing is known.
  std::string silence() const;
  void warnWithoutPublisher();
  /// True when the camera was asked for a cloud and answered.
  bool triggerCamera(std::chrono::steady_clock::time_point deadline);
  bool capture() const;
  std::string captureService() const;
  std::string cameraSilent() const;  // for people

  const DetectorOptions options_;
  ros::CallbackQueue cloud_queue_;
  ros::CallbackQueue service_queue_;
  ros::CallbackQueue diagnostics_queue_;
  ros::NodeHandle cloud_node_;    // calls back on the cloud thread
  ros::NodeHandle service_node_;  // calls back on the service threads
  ros::NodeHandle diagnostics_node_;
  FaultCounter drops_;
  CloudInbox inbox_;
  CameraTrigger camera_;
  BaseFrameKeeper base_frame_;
  std::unique_ptr<DetectorOutputs> outputs_;
  std::unique_ptr<DetectorDiagnostics> diagnostics_;
  std::mutex calibrating_;
  std::unique_ptr<CalibrationRun> first_calibration_;  // of the cloud thread

  std::mutex processing_;  // guards the next five
  detection::DetectionOptions detection_options_;
  std::uint64_t detector_revision_ = 0;  // of the calibration that the detector knows
  detection::BoxDetector detector_;
  std::uint64_t processed_sequence_ = 0;
  Processed processed_;

  ros::Publisher marker_image_;
  ros::Subscriber points_;
  ros::ServiceServer detect_service_;
  ros::ServiceServer calibrate_service_;
  ros::SteadyTimer diagnostics_timer_;
  int ticks_without_publisher_ = 0;  // of that timer
  ros::AsyncSpinner cloud_spinner_;
  ros::AsyncSpinner service_spinner_;
  ros::AsyncSpinner diagnostics_spinner_;
  std::unique_ptr<DetectionTuning> tuning_;
};

}  // namespace mixed_palletizing::adapters
