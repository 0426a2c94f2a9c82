#include <Eigen/Geometry>

#include <mixed_palletizing/simulation/scene_object.hpp>

namespace mixed_palletizing::simulation {

geometry::Pose poseFromRollPitchYaw(const Eigen::Vector3d& position_m, const Eigen::Vector3d& rpy_rad) {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.linear() = (Eigen::AngleAxisd(rpy_rad.z(), Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(rpy_rad.y(), Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(rpy_rad.x(), Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation() = position_m;
  return pose;
}

}  // namespace mixed_palletizing::simulation
