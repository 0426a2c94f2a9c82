// How far a detection is from the box that it is.
#pragma once

#include <array>

#include <Eigen/Core>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/experiments/scene_truth.hpp>

namespace mixed_palletizing::experiments {

/// The seven numbers of a box that are measured against the truth.
enum Quantity : std::size_t { kX, kY, kTopZ, kYaw, kLength, kWidth, kHeight, kQuantityCount };

/// Names of the quantities in records: x, y, top_z, yaw, length, width, height.
const char* toString(Quantity quantity);

/// Found minus true, in metres and radians.
struct BoxErrors {
  std::array<double, kQuantityCount> error{};
  std::array<double, kQuantityCount> stddev{};               ///< as reported
  Eigen::Vector3d camera_error_m = Eigen::Vector3d::Zero();  ///< of the top's centre, in the camera's frame
  /// Rotation vector of the box's orientation in the camera's frame.
  Eigen::Vector3d camera_turn_rad = Eigen::Vector3d::Zero();
  unsigned flags = 0;

  /// Horizontal distance of the top's centre [m]: the "position" of tables.
  double position() const;
  /// Both sides of the top are reported with a standard deviation of at most kKnownStddev, and not as
  /// INCOMPLETE.
  bool isComplete() const;
  bool isKnown(Quantity size) const { return stddev[size] <= kKnownStddev; }
  /// A size is wrong by more than 5 mm and three reported standard deviations.
  bool hasSizeBeyondStddev() const;
  /// The same without a flag (OCCLUDED, TRUNCATED, INCOMPLETE) that warns of it.
  bool hasConfidentWrongSize() const;

  static constexpr double kKnownStddev = 0.01;  ///< [m]
};

/// The yaw is compared modulo half a turn. When the true sides differ by less than kNearlySquare, or the detection
/// is INCOMPLETE, its length may lie along the true width: whichever gives the smaller angle. `found_base` and
/// `true_base` are base_from_camera as found and as it is.
BoxErrors boxErrors(const TrueBox& truth, const detection::DetectedBox& box, const geometry::Pose& true_base,
                    const geometry::Pose& found_base);

constexpr double kNearlySquare = 0.01;  ///< [m]

/// How far a base frame is from the true one.
struct BaseFrameErrors {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< true origin in the found frame
  double tilt_rad = 0.0;                               ///< between the z axes
  double yaw_rad = 0.0;                                ///< of the x axis about z
};

BaseFrameErrors baseFrameErrors(const geometry::Pose& true_base, const geometry::Pose& found_base);

}  // namespace mixed_palletizing::experiments
