#include <filesystem>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include <ros/console.h>
#include <tf2_eigen/tf2_eigen.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <mixed_palletizing/adapters/base_frame_keeper.hpp>
#include <mixed_palletizing/adapters/calibration_file.hpp>
#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/static_transforms.hpp>
#include <mixed_palletizing/adapters/transform_lookup.hpp>

namespace mixed_palletizing::adapters {
namespace {

BaseFrameAnswer missing(const std::string& reason, const std::string& message) {
  return {std::nullopt, reason, message, 0};
}

void makeFolderOf(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(folder.string() + ": " + error.message());
}

std::string poseText(const geometry::Pose& base_from_camera) {
  const Eigen::Vector3d p = base_from_camera.translation();
  const Eigen::Vector3d view = base_from_camera.linear().col(2);
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "camera at (" << p.x() << ", " << p.y() << ", " << p.z()
       << ") m, looking along (" << view.x() << ", " << view.y() << ", " << view.z() << ")";
  return text.str();
}

}  // namespace

BaseFrameKeeper::BaseFrameKeeper(const DetectorOptions& options) : options_(options) {
  if (options_.base_source == BaseSource::kTf) {
    buffer_ = std::make_unique<tf2_ros::Buffer>();
    buffer_->setUsingDedicatedThread(true);
    listener_ = std::make_unique<tf2_ros::TransformListener>(*buffer_);
    return;
  }
  if (options_.calibration_file.empty()) return;
  const bool needed = options_.base_source == BaseSource::kFile;
  if (!needed && !std::filesystem::exists(options_.calibration_file)) return;
  try {
    restore();
  } catch (const std::exception& error) {
    if (needed) throw;
    ROS_WARN_STREAM("calibration not restored, calibrate again: " << error.what());
  }
}

BaseFrameKeeper::~BaseFrameKeeper() = default;

void BaseFrameKeeper::restore() {
  const Calibration kept = readCalibration(options_.calibration_file);
  if (!kept.base_frame.empty() && kept.base_frame != options_.base_frame) {
    throw std::runtime_error(options_.calibration_file + ": its base frame is '" + kept.base_frame +
                             "', not '" + options_.base_frame + "'");
  }
  camera_frame_ = kept.camera_frame;
  base_from_camera_ = kept.base_from_camera;
  removed_planes_ = kept.removed_planes;
  ++revision_;
  origin_ = "from " + options_.calibration_file;
  publish();
}

BaseFrameAnswer BaseFrameKeeper::find(const std::string& camera_frame, const ros::Time& stamp) {
  if (options_.base_source == BaseSource::kTf) return lookUp(camera_frame, stamp);
  std::lock_guard<std::mutex> lock(mutex_);
  if (!base_from_camera_) {
    return missing("not_calibrated", "there is no base frame yet: call the service calibrate");
  }
  if (camera_frame_.empty()) {  // a file that names no camera is of the first one that comes
    camera_frame_ = camera_frame;
    publish();
  }
  if (camera_frame != camera_frame_) {
    return missing("wrong_camera_frame", "the cloud comes from frame '" + camera_frame +
                                             "', the calibration is of '" + camera_frame_ + "'");
  }
  return {base_from_camera_, "", "", revision_};
}

BaseFrameAnswer BaseFrameKeeper::lookUp(const std::string& camera_frame, const ros::Time& stamp) const {
  const FoundTransform found =
      lookUpTransform(*buffer_, options_.base_frame, camera_frame, stamp, options_.tf_timeout_s);
  if (!found.transform) return missing("no_transform", found.problem);
  return {geometry::Pose(tf2::transformToEigen(*found.transform)), "", "", 0};
}

void BaseFrameKeeper::set(const std::string& camera_frame, const geometry::Pose& base_from_camera,
                          const std::vector<geometry::Plane>& removed_planes) {
  if (!options_.calibration_file.empty()) {
    makeFolderOf(options_.calibration_file);
    Calibration calibration;
    calibration.base_frame = options_.base_frame;
    calibration.camera_frame = camera_frame;
    calibration.base_from_camera = base_from_camera;
    calibration.removed_planes = removed_planes;
    writeCalibration(options_.calibration_file, calibration);
  }
  std::lock_guard<std::mutex> lock(mutex_);
  camera_frame_ = camera_frame;
  base_from_camera_ = base_from_camera;
  removed_planes_ = removed_planes;
  ++revision_;
  origin_ = "calibrated in this run";
  publish();
}

void BaseFrameKeeper::publish() const {
  if (!options_.publish_tf || camera_frame_.empty()) return;
  const ros::Time now = ros::Time::now();
  if (options_.tf_direction == TfDirection::kCameraToBase) {
    publishStaticTransform(camera_frame_, options_.base_frame, base_from_camera_->inverse(), now);
  } else {
    publishStaticTransform(options_.base_frame, camera_frame_, *base_from_camera_, now);
  }
}

std::vector<geometry::Plane> BaseFrameKeeper::removedPlanes() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return removed_planes_;
}

bool BaseFrameKeeper::calibrated() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return options_.base_source == BaseSource::kTf || base_from_camera_.has_value();
}

std::string BaseFrameKeeper::description() const {
  if (options_.base_source == BaseSource::kTf) return "from tf for every cloud";
  std::lock_guard<std::mutex> lock(mutex_);
  return base_from_camera_ ? origin_ + ": " + poseText(*base_from_camera_) : "not calibrated";
}

}  // namespace mixed_palletizing::adapters
