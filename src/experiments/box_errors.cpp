#include <algorithm>
#include <cmath>
#include <utility>

#include <mixed_palletizing/experiments/box_errors.hpp>

namespace mixed_palletizing::experiments {
namespace {

constexpr double kWrong = 0.005;       // [m]
constexpr double kWrongStddevs = 3.0;  // reported standard deviations

Eigen::Matrix3d turnAboutZ(double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/// Rotation from the true to the found orientation of the box in the camera's frame.
Eigen::Vector3d cameraTurn(double true_yaw, double found_yaw, const geometry::Pose& true_base,
                           const geometry::Pose& found_base) {
  const Eigen::Matrix3d real = true_base.linear().transpose() * turnAboutZ(true_yaw);
  const Eigen::Matrix3d seen = found_base.linear().transpose() * turnAboutZ(found_yaw);
  const Eigen::AngleAxisd turn(seen * real.transpose());
  return turn.angle() * turn.axis();
}

}  // namespace

const char* toString(Quantity quantity) {
  switch (quantity) {
    case kX:
      return "x";
    case kY:
      return "y";
    case kTopZ:
      return "top_z";
    case kYaw:
      return "yaw";
    case kLength:
      return "length";
    case kWidth:
      return "width";
    case kHeight:
      return "height";
    case kQuantityCount:
      break;
  }
  return "";
}

double BoxErrors::position() const { return std::hypot(error[kX], error[kY]); }

bool BoxErrors::isComplete() const {
  return isKnown(kLength) && isKnown(kWidth) && (flags & detection::kIncomplete) == 0u;
}

bool BoxErrors::hasSizeBeyondStddev() const {
  for (const Quantity size : {kLength, kWidth, kHeight}) {
    if (std::abs(error[size]) > std::max(kWrong, kWrongStddevs * stddev[size])) return true;
  }
  return false;
}

bool BoxErrors::hasConfidentWrongSize() const {
  const unsigned warning = detection::kOccluded | detection::kTruncated | detection::kIncomplete;
  return (flags & warning) == 0u && hasSizeBeyondStddev();
}

BoxErrors boxErrors(const TrueBox& truth, const detection::DetectedBox& box, const geometry::Pose& true_base,
                    const geometry::Pose& found_base) {
  BoxErrors errors;
  Eigen::Vector2d real = truth.size.head<2>();
  double real_yaw = truth.yaw_rad;
  const double straight = std::abs(geometry::foldHalfTurn(box.yaw_rad - real_yaw));
  // Of a side that is not known to its end nobody can say whether it is the longer one.
  const bool open = (box.flags & detection::kIncomplete) != 0u || real.x() - real.y() < kNearlySquare;
  if (open && straight > M_PI / 4) {
    std::swap(real.x(), real.y());
    real_yaw += M_PI / 2;
  }
  const double turn = geometry::foldHalfTurn(box.yaw_rad - real_yaw);
  const Eigen::Vector3d shift = box.top_center - truth.top_center;
  errors.error = {shift.x(),
                  shift.y(),
                  shift.z(),
                  turn,
                  box.size.x() - real.x(),
                  box.size.y() - real.y(),
                  box.size.z() - truth.size.z()};
  const auto sigma = [&](int i) { return std::sqrt(std::max(0.0, box.pose_covariance(i, i))); };
  // The top is one height above the floor: its uncertainty is that of the height.
  errors.stddev = {
      sigma(0),           sigma(1), box.size_stddev.z(), sigma(5), box.size_stddev.x(), box.size_stddev.y(),
      box.size_stddev.z()};
  errors.camera_error_m = found_base.inverse() * box.top_center - true_base.inverse() * truth.top_center;
  errors.camera_turn_rad = cameraTurn(real_yaw, real_yaw + turn, true_base, found_base);
  errors.flags = box.flags;
  return errors;
}

BaseFrameErrors baseFrameErrors(const geometry::Pose& true_base, const geometry::Pose& found_base) {
  const geometry::Pose found_from_true = found_base * true_base.inverse();
  BaseFrameErrors errors;
  errors.origin_m = found_from_true.translation();
  const Eigen::Vector3d z = found_from_true.linear().col(2);
  errors.tilt_rad = std::atan2(z.head<2>().norm(), z.z());
  errors.yaw_rad = std::atan2(found_from_true.linear()(1, 0), found_from_true.linear()(0, 0));
  return errors;
}

}  // namespace mixed_palletizing::experiments
