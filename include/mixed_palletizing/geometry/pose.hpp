// Rigid poses and the small angle helpers that every room needs.
#pragma once

#include <Eigen/Geometry>

namespace mixed_palletizing::geometry {

/// Rigid transform. A pose named a_from_b maps points of frame b into frame a: p_a = a_from_b * p_b.
using Pose = Eigen::Isometry3d;

/// Rotation that turns the unit vector `from` onto the unit vector `to` by axis and angle (thesis eq. 3.6);
/// for opposite vectors any axis perpendicular to `from`.
Eigen::Matrix3d alignVectors(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Angle [rad] folded into [-pi/2, pi/2): the yaw of a box, which repeats every half turn.
double foldHalfTurn(double angle_rad);

/// Angle [rad] folded into [-pi/4, pi/4): the direction of a rectangle's sides, which repeats every quarter
/// turn.
double foldQuarterTurn(double angle_rad);

/// Pose with translation [m] and rotation by yaw [rad] about z.
Pose poseFromYaw(const Eigen::Vector3d& translation, double yaw_rad);

/// Rotation about z [rad] of a pose whose z axis points up.
double yawOf(const Pose& pose);

}  // namespace mixed_palletizing::geometry
