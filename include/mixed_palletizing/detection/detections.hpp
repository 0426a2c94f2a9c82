// What a detection answers: boxes with pose, size and uncertainty, and the clusters that were refused and
// why.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mixed_palletizing::detection {

/// Bits of DetectedBox::flags; the values are those of Box.msg.
enum BoxFlag : std::uint8_t {
  kOccluded = 1,        ///< a part of the top is hidden by something nearer to the camera
  kTruncated = 2,       ///< the top reaches the border of the image
  kTouching = 4,        ///< another box touches this one
  kUnevenTop = 8,       ///< the top is bulged, dented or tilted beyond the tolerance
  kIncomplete = 16,     ///< a side of the top was not found: pose and size are completed from the others
  kHeightUnknown = 32,  ///< in a stack: no side face of its own is seen, the height is a guess
};

/// A box in the base frame (z up). Lengths in metres, angles in radians.
struct DetectedBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();      ///< centre of the solid
  Eigen::Vector3d top_center = Eigen::Vector3d::Zero();  ///< centre of the top face
  /// Of the plane that fits the top best, up, length 1: how far the top leans. Pose and size are those of an
  /// upright box.
  Eigen::Vector3d top_normal = Eigen::Vector3d::UnitZ();
  double yaw_rad = 0.0;                            ///< of the length axis about z, in [-pi/2, pi/2)
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< length >= width, height
  Eigen::Vector3d size_stddev = Eigen::Vector3d::Zero();
  /// Covariance of (x, y, z, roll, pitch, yaw), row-major, about the fixed axes of the base frame (REP 103).
  Eigen::Matrix<double, 6, 6> pose_covariance = Eigen::Matrix<double, 6, 6>::Zero();
  double top_visibility = 1.0;  ///< seen share of the top's area, [0, 1]
  std::uint32_t point_count = 0;
  std::uint8_t flags = 0;  ///< BoxFlag bits
};

/// Why a cluster is no box; the values are those of RejectedCluster.msg.
enum class RejectReason : std::uint8_t {
  kTooFewPoints = 1,
  kTooSmall = 2,
  kTooLarge = 3,
  kNoTopPlane = 4,
  kNotRectangular = 5,
};

/// Lower-case words of a reason, as in messages, files and diagnostics.
const char* toString(RejectReason reason);

struct RejectedCluster {
  RejectReason reason = RejectReason::kTooFewPoints;
  std::string text;                                    ///< the measured value and the limit it broke
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< base frame [m]
  Eigen::Vector3d extent = Eigen::Vector3d::Zero();    ///< of the axis-aligned bounds in the base frame [m]
};

struct StageTime {
  const char* stage = "";
  double milliseconds = 0.0;
};

/// Pixels (row * width + column) that one stage of the chain kept; filled only on request.
struct StagePixels {
  const char* stage = "";
  std::vector<std::uint32_t> pixels;
};

struct Detections {
  std::vector<DetectedBox> boxes;
  std::vector<RejectedCluster> rejected;
  std::vector<std::uint16_t> labels;  ///< row-major grid of the cloud: 0 = none, i + 1 = boxes[i]
  int width = 0;
  int height = 0;
  double valid_ratio = 0.0;  ///< share of the points that carry data
  std::vector<StageTime> stage_times;
  std::vector<StagePixels> stage_pixels;
};

}  // namespace mixed_palletizing::detection
