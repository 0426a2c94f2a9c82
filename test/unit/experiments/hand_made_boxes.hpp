// A true box and its perfect detection.
#pragma once

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/experiments/scene_truth.hpp>

namespace mixed_palletizing::test {

inline experiments::TrueBox trueBox(double x, double y, double yaw_rad = 0.0,
                                    const Eigen::Vector3d& size = {0.3, 0.2, 0.15}) {
  experiments::TrueBox box;
  box.top_center = Eigen::Vector3d(x, y, size.z());
  box.size = size;
  box.yaw_rad = yaw_rad;
  box.visible_ratio = 1.0;
  box.measured_ratio = 1.0;
  return box;
}

inline detection::DetectedBox detected(const experiments::TrueBox& truth, double stddev_m = 0.001) {
  detection::DetectedBox box;
  box.top_center = truth.top_center;
  box.center = truth.top_center - Eigen::Vector3d(0.0, 0.0, 0.5 * truth.size.z());
  box.yaw_rad = truth.yaw_rad;
  box.size = truth.size;
  box.size_stddev = Eigen::Vector3d::Constant(stddev_m);
  box.pose_covariance.setIdentity();
  box.pose_covariance *= stddev_m * stddev_m;
  return box;
}

}  // namespace mixed_palletizing::test
