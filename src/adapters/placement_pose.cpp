// The part of pallet_messages that turns boxes to their places.
#include <limits>

#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/pallet_messages.hpp>
#include <mixed_palletizing/adapters/units.hpp>

namespace mixed_palletizing::adapters {
namespace {

Eigen::Vector3d metersOf(const packing::Vec3& v) { return {toMeters(v.x), toMeters(v.y), toMeters(v.z)}; }

/// Rotations that put a box's own axes along the pallet's, the least turning first. Column j is the own
/// axis j in the pallet frame.
std::array<Eigen::Matrix3d, 6> axisRotations() {
  std::array<Eigen::Matrix3d, 6> rotations;
  rotations[0] << 1, 0, 0, 0, 1, 0, 0, 0, 1;   // as it is
  rotations[1] << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // turned about the vertical
  rotations[2] << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // tilted about its y: x side vertical
  rotations[3] << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // tilted about its x: y side vertical
  rotations[4] << 0, 0, 1, 1, 0, 0, 0, 1, 0;   // both
  rotations[5] << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return rotations;
}

}  // namespace

void setApproach(Placement& placement, const packing::Vec3& last_stretch) {
  const bool is_straight = last_stretch == packing::Vec3{};
  const Eigen::Vector3d stretch =
      is_straight ? Eigen::Vector3d(-Eigen::Vector3d::UnitZ()) : metersOf(last_stretch);
  placement.approach = vectorMessage(stretch.normalized());
  placement.approach_distance = is_straight ? 0.0 : stretch.norm();
}

void alignPose(Placement& placement, const std::array<double, 3>& own_size) {
  const Eigen::Vector3d own(own_size[0], own_size[1], own_size[2]);
  const Eigen::Vector3d placed = toEigen(placement.size);
  constexpr double kClearlyBetterM = 1e-3;  // ties go to the lesser turn
  double best = std::numeric_limits<double>::infinity();
  for (const Eigen::Matrix3d& rotation : axisRotations()) {
    const double mismatch = (rotation.cwiseAbs() * own - placed).cwiseAbs().sum();
    if (mismatch >= best - kClearlyBetterM) continue;
    best = mismatch;
    placement.pose.orientation = quaternionMessage(rotation);
  }
}

}  // namespace mixed_palletizing::adapters
