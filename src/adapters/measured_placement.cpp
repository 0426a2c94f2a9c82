#include <algorithm>
#include <cmath>

#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/pallet_messages.hpp>
#include <mixed_palletizing/adapters/units.hpp>

namespace mixed_palletizing::adapters {
namespace {

Eigen::Vector3d metersOf(const packing::Vec3& v) { return {toMeters(v.x), toMeters(v.y), toMeters(v.z)}; }

}  // namespace

MeasuredPlacement measuredPlacement(const geometry_msgs::Pose& pose, const packing::Placement& planned,
                                    double position_tolerance_m, double angle_tolerance_rad) {
  const Eigen::Vector3d center = toEigen(pose.position);
  if (!isLength(center.x()) || !isLength(center.y()) || !isLength(center.z())) {
    return {std::nullopt, "actual_pose.position is no position"};
  }
  if (!isRotation(pose.orientation)) return {std::nullopt, "actual_pose.orientation is no rotation"};
  const auto& o = pose.orientation;
  const Eigen::Matrix3d rotation = Eigen::Quaterniond(o.w, o.x, o.y, o.z).normalized().toRotationMatrix();
  // Along the sides: every axis of the box is within the tolerance of an axis of the pallet.
  const double worst = std::acos(std::min(1.0, rotation.cwiseAbs().colwise().maxCoeff().minCoeff()));
  if (worst > angle_tolerance_rad) {
    return {std::nullopt, "the box stands " + std::to_string(worst * 180.0 / M_PI) +
                              " degrees off the pallet's sides, more than " +
                              std::to_string(angle_tolerance_rad * 180.0 / M_PI)};
  }
  const Eigen::Vector3d corner = center - metersOf(planned.size) / 2.0;
  if ((corner - metersOf(planned.origin)).cwiseAbs().maxCoeff() <= position_tolerance_m) return {planned, ""};
  packing::Placement placement = planned;
  placement.origin = {millimetersNearest(corner.x()), millimetersNearest(corner.y()),
                      millimetersNearest(corner.z())};
  return {placement, ""};
}

}  // namespace mixed_palletizing::adapters
