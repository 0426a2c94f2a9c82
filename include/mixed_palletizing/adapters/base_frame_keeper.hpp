// Where the base frame is for a camera: calibrated, read from a file, or asked from tf.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <ros/time.h>

#include <mixed_palletizing/adapters/detector_options.hpp>
#include <mixed_palletizing/geometry/plane.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace tf2_ros {
class Buffer;
class TransformListener;
}  // namespace tf2_ros

namespace mixed_palletizing::adapters {

/// A base frame, or why there is none.
struct BaseFrameAnswer {
  std::optional<geometry::Pose> base_from_camera;
  std::string reason;          ///< a word: "not_calibrated", "wrong_camera_frame", "no_transform"
  std::string message;         ///< what to do about it
  std::uint64_t revision = 0;  ///< of the calibration: another number, other removed planes
};

/// Thread safe.
class BaseFrameKeeper {
 public:
  /// Restores the calibration of an earlier run, and publishes it. Throws std::runtime_error when base_source
  /// is `file` and the file cannot be used; a file that cannot be used otherwise only means not calibrated.
  explicit BaseFrameKeeper(const DetectorOptions& options);
  ~BaseFrameKeeper();

  /// Base frame of a cloud from `camera_frame` at time `stamp`.
  BaseFrameAnswer find(const std::string& camera_frame, const ros::Time& stamp);

  /// Takes a new calibration into use: kept in the file, published on /tf_static. Throws std::runtime_error
  /// when the file cannot be written; nothing has changed then.
  void set(const std::string& camera_frame, const geometry::Pose& base_from_camera,
           const std::vector<geometry::Plane>& removed_planes = {});

  /// Planes of the base frame that the calibration in use knows to be no places of boxes.
  std::vector<geometry::Plane> removedPlanes() const;

  bool calibrated() const;

  /// One line for people: what is in use and where it comes from.
  std::string description() const;

 private:
  void restore();
  void publish() const;
  BaseFrameAnswer lookUp(const std::string& camera_frame, const ros::Time& stamp) const;

  const DetectorOptions options_;
  mutable std::mutex mutex_;
  std::string camera_frame_;
  std::optional<geometry::Pose> base_from_camera_;
  std::string origin_;  // of what is in use
  std::vector<geometry::Plane> removed_planes_;
  std::uint64_t revision_ = 0;
  std::unique_ptr<tf2_ros::Buffer> buffer_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
};

}  // namespace mixed_palletizing::adapters
