// Small pieces of geometry messages.
#pragma once

#include <cmath>

#include <Eigen/Geometry>
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Vector3.h>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::adapters {

inline geometry_msgs::Point pointMessage(const Eigen::Vector3d& p) {
  geometry_msgs::Point message;
  message.x = p.x();
  message.y = p.y();
  message.z = p.z();
  return message;
}

inline geometry_msgs::Vector3 vectorMessage(const Eigen::Vector3d& v) {
  geometry_msgs::Vector3 message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

inline geometry_msgs::Quaternion quaternionMessage(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
  geometry_msgs::Quaternion message;
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  message.w = q.w();
  return message;
}

inline geometry_msgs::Pose poseMessage(const geometry::Pose& pose) {
  geometry_msgs::Pose message;
  message.position = pointMessage(pose.translation());
  message.orientation = quaternionMessage(pose.linear());
  return message;
}

template <typename Xyz>
Eigen::Vector3d toEigen(const Xyz& v) {
  return {v.x, v.y, v.z};
}

/// Unit length within one percent and finite: something that can be normalized without guessing.
inline bool isRotation(const geometry_msgs::Quaternion& q) {
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return std::isfinite(norm) && std::abs(norm - 1.0) < 0.01;
}

}  // namespace mixed_palletizing::adapters
