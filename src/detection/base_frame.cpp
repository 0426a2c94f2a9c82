// Base frame (thesis 3.2.1 "Base-frame detection", "Transformation"):
//   1. the floor is the largest plane, by RANSAC with eq. 3.4 and least squares (plane_ransac);
//   2. markers are found in the colour (marker) and fitted on the floor to all edges of their cells (marker_fit): an
//      edge lies on the border of the ink, where the camera may have no data, so its viewing ray, known from the
//      measured pixels around it (lens_rays), is met with the plane instead of looking up one pixel;
//   3. origin and x direction are those of the fitted picture; the thesis takes the median of four edges' directions
//      (eq. 3.7). Several markers at known places are fitted jointly.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/SVD>

#include <mixed_palletizing/detection/base_frame.hpp>

#include "floor_choice.hpp"
#include "marker_frame.hpp"
#include "plane_map.hpp"
#include "plane_ransac.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kUpright =
    0.34;  // z of the normal of a plane that stands: less than 20 degrees from upright

geometry::Pose poseFrom(const Eigen::Matrix3d& base_from_camera, const Eigen::Vector3d& origin_in_camera) {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.linear() = base_from_camera;
  pose.translation() = -(base_from_camera * origin_in_camera);
  return pose;
}

FoundPlane inBase(const PlaneFit& fit, const geometry::Pose& base_from_camera) {
  FoundPlane found;
  found.inliers = fit.inliers;
  found.rms_m = fit.rms_m;
  const Eigen::Vector3d normal = base_from_camera.linear() * fit.plane.normal;
  const Eigen::Vector3d middle = base_from_camera * fit.centroid;
  found.plane = {normal, -normal.dot(middle)};
  // x along the base frame's x as far as that lies in the plane, else along its y.
  Eigen::Vector3d x = Eigen::Vector3d::UnitX() - normal.x() * normal;
  if (x.norm() < 0.5) x = Eigen::Vector3d::UnitY() - normal.y() * normal;
  x.normalize();
  found.base_from_plane.linear() << x, normal.cross(x), normal;
  found.base_from_plane.translation() = middle;
  return found;
}

}  // namespace

BaseFrameResult findBaseFrame(const geometry::CloudView& cloud, BaseFrameSource source,
                              const DetectionOptions& options) {
  if (cloud.data == nullptr || cloud.width <= 0 || cloud.height <= 0) {
    throw std::invalid_argument("findBaseFrame: cloud: no data or no size (" + std::to_string(cloud.width) +
                                " x " + std::to_string(cloud.height) + " points)");
  }
  BaseFrameResult result;
  const PlanesResult planes = findPlanes(cloud, options.plane);
  if (planes.fits.empty()) {
    result.message = planes.message;
    return result;
  }
  const FloorChoiceResult choice = chooseFloor(cloud, planes.fits, options);
  if (!choice.floor) {
    result.message = choice.message;
    return result;
  }
  BaseFrame frame;
  const PlaneFit& floor = planes.fits[*choice.floor];
  frame.floor = floor.plane;
  frame.plane_inliers = floor.inliers;
  frame.plane_rms_m = floor.rms_m;
  if (source == BaseFrameSource::kFloor) {
    // Origin at the foot of the camera's perpendicular, x = the camera's x projected on the floor.
    frame.base_from_camera = floorFrame(PlaneAxes(frame.floor), Eigen::Vector2d::Zero(), 0.0);
  } else {
    result.message = placeOnMarkers(cloud, options, frame);
    if (!result.message.empty()) return result;
  }
  for (const PlaneFit& fit : planes.fits) {
    if (&fit != &floor) frame.planes.push_back(inBase(fit, frame.base_from_camera));
  }
  result.frame = frame;
  return result;
}

std::vector<geometry::Plane> removedPlanes(const BaseFrame& frame, RemovedPlanes which) {
  std::vector<geometry::Plane> removed;
  for (const FoundPlane& found : frame.planes) {
    const bool upright = std::abs(found.plane.normal.z()) < kUpright;
    if (which == RemovedPlanes::kAll || (which == RemovedPlanes::kUpright && upright))
      removed.push_back(found.plane);
  }
  return removed;
}

AveragedBaseFrame averageBaseFrames(const std::vector<BaseFrame>& frames) {
  if (frames.empty()) throw std::invalid_argument("averageBaseFrames: frames: none given");
  AveragedBaseFrame average;
  average.frame = frames.front();
  average.frame.plane_inliers = 0;
  average.frame.plane_rms_m = 0.0;
  const double n = static_cast<double>(frames.size());
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // of the base frame, in the camera frame
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
  for (const BaseFrame& frame : frames) {
    origin += frame.base_from_camera.inverse().translation() / n;
    rotation += frame.base_from_camera.linear() / n;
    average.frame.plane_inliers += frame.plane_inliers;
    average.frame.plane_rms_m += frame.plane_rms_m / n;
  }
  // The rotation nearest to the mean matrix.
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(rotation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  average.frame.base_from_camera = poseFrom(svd.matrixU() * svd.matrixV().transpose(), origin);
  for (const BaseFrame& frame : frames) {
    const Eigen::Vector3d other = frame.base_from_camera.inverse().translation();
    average.spread_m = std::max(average.spread_m, (other - origin).norm());
    const Eigen::AngleAxisd turn(frame.base_from_camera.linear() *
                                 average.frame.base_from_camera.linear().transpose());
    average.spread_rad = std::max(average.spread_rad, std::abs(turn.angle()));
  }
  return average;
}

}  // namespace mixed_palletizing::detection
