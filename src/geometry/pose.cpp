#include <cmath>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::geometry {
namespace {

/// Angle folded into [-period/2, period/2).
double fold(double angle_rad, double period_rad) {
  const double folded = angle_rad - period_rad * std::floor(angle_rad / period_rad + 0.5);
  // Rounding can land exactly on the open end.
  return folded >= period_rad / 2 ? folded - period_rad : folded;
}

}  // namespace

Eigen::Matrix3d alignVectors(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  // Eq. 3.6 divides by |k| = sin(theta); Eigen's half-angle form is the same rotation and stays finite at 0
  // and pi.
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

double foldHalfTurn(double angle_rad) { return fold(angle_rad, M_PI); }

double foldQuarterTurn(double angle_rad) { return fold(angle_rad, M_PI / 2); }

Pose poseFromYaw(const Eigen::Vector3d& translation, double yaw_rad) {
  Pose pose = Pose::Identity();
  pose.translation() = translation;
  pose.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

double yawOf(const Pose& pose) { return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)); }

}  // namespace mixed_palletizing::geometry
