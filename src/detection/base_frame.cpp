// Base frame (thesis 3.2.1 "Base-frame detection", "Transformation"):
//   1. the floor is the largest plane, by RANSAC with eq. 3.4 and least squares (plane_ransac);
//   2. marker corners are found in the colour and carried into 3D: a corner lies on the border of the ink, where
//      the camera may have no data, so its viewing ray, taken from the measured pixels around it, is met with
//      the floor instead of looking up one pixel;
//   3. the floor's normal is turned onto z by axis and angle (eq. 3.6; the thesis has y up), then the frame is
//      turned about it by the median of the four edges' directions (eq. 3.7).
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <Eigen/SVD>

#include <mixed_palletizing/detection/base_frame.hpp>

#include "marker.hpp"
#include "pixel_rays.hpp"
#include "plane_ransac.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr std::size_t kRayPixels = 200;  // enough measured pixels around a corner
constexpr int kLargestWindow = 120;      // half width [px] in which they are looked for

/// Viewing ray (x / z, y / z, 1) of a pixel from measured pixels in a growing window around it.
std::optional<Eigen::Vector3d> rayThrough(const geometry::CloudView& cloud, const Eigen::Vector2d& pixel) {
  const int col = static_cast<int>(std::lround(pixel.x()));
  const int row = static_cast<int>(std::lround(pixel.y()));
  for (int half = 10; half <= kLargestWindow; half *= 2) {
    PixelRays rays;
    for (int r = std::max(0, row - half); r <= std::min(cloud.height - 1, row + half); ++r) {
      for (int c = std::max(0, col - half); c <= std::min(cloud.width - 1, col + half); ++c) {
        const Eigen::Vector3f p = cloud.point(r, c);
        if (p.z() > 0.0f && p.allFinite()) rays.add(c, r, p);
      }
    }
    if (rays.count() < kRayPixels || !rays.fit()) continue;
    const Eigen::Vector2d ray = rays.ray(pixel.x(), pixel.y());
    return Eigen::Vector3d(ray.x(), ray.y(), 1.0);
  }
  return std::nullopt;
}

/// The marker's corners on the plane; nothing when one of them has no measured surroundings.
std::optional<MarkerSighting> locate(const geometry::CloudView& cloud, const geometry::Plane& floor,
                                     const PixelMarker& marker) {
  MarkerSighting sighting;
  sighting.id = marker.id;
  sighting.corners_px = marker.corners_px;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto ray = rayThrough(cloud, marker.corners_px[i]);
    if (!ray) return std::nullopt;
    const double slope = floor.normal.dot(*ray);
    if (!(std::abs(slope) > 1e-6)) return std::nullopt;
    sighting.corners[i] = -floor.offset / slope * *ray;
    if (!(sighting.corners[i].z() > 0.0)) return std::nullopt;
  }
  return sighting;
}

/// Median direction [rad] of the four edges on the floor (frame `level`: z up), each turned back onto the
/// edge from corner 0 to corner 1.
double markerYaw(const MarkerSighting& marker, const Eigen::Matrix3d& level) {
  std::array<double, 4> yaw{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d edge = level * (marker.corners[(i + 1) % 4] - marker.corners[i]);
    // OpenCV's corners run clockwise as the camera sees them, so edge i points i quarter turns to the right.
    yaw[i] = std::atan2(edge.y(), edge.x()) + static_cast<double>(i) * M_PI / 2;
    yaw[i] = yaw[0] + std::remainder(yaw[i] - yaw[0], 2.0 * M_PI);
  }
  std::sort(yaw.begin(), yaw.end());
  return 0.5 * (yaw[1] + yaw[2]);
}

geometry::Pose poseFrom(const Eigen::Matrix3d& base_from_camera, const Eigen::Vector3d& origin_in_camera) {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.linear() = base_from_camera;
  pose.translation() = -(base_from_camera * origin_in_camera);
  return pose;
}

Eigen::Matrix3d turnedBy(double yaw_rad, const Eigen::Matrix3d& level) {
  return Eigen::AngleAxisd(-yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() * level;
}

/// Origin at the foot of the camera's perpendicular, x = the camera's x (its y when the camera's x stands
/// upright) projected on the floor.
geometry::Pose floorPose(const geometry::Plane& floor) {
  const Eigen::Matrix3d level = geometry::alignVectors(floor.normal, Eigen::Vector3d::UnitZ());
  Eigen::Vector3d x = level.col(0);
  if (x.head<2>().norm() < 1e-6) x = level.col(1);
  return poseFrom(turnedBy(std::atan2(x.y(), x.x()), level), -floor.offset * floor.normal);
}

geometry::Pose markerPose(const geometry::Plane& floor, const MarkerSighting& marker) {
  const Eigen::Matrix3d level = geometry::alignVectors(floor.normal, Eigen::Vector3d::UnitZ());
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : marker.corners) center += 0.25 * corner;
  return poseFrom(turnedBy(markerYaw(marker, level), level), center);
}

std::string notSeen(const MarkerOptions& options, const std::vector<PixelMarker>& seen) {
  std::ostringstream message;
  message << "marker " << options.id << " of " << options.dictionary << " not seen; ";
  if (seen.empty()) {
    message << "no marker of that dictionary is in the image";
    return message.str();
  }
  message << "seen:";
  for (const PixelMarker& marker : seen) message << ' ' << marker.id;
  return message.str();
}

/// Fills the frame from the wanted marker; returns what is wrong.
std::string useMarker(const geometry::CloudView& cloud, const MarkerOptions& options, BaseFrame& frame) {
  if (!cloud.hasColor()) return "the cloud has no colour to look for a marker in";
  const std::vector<PixelMarker> seen = detectMarkers(cloud, options);
  if (seen.empty() || seen.front().id != options.id) return notSeen(options, seen);
  for (const PixelMarker& marker : seen) {
    const auto sighting = locate(cloud, frame.floor, marker);
    if (sighting) frame.markers.push_back(*sighting);
  }
  if (frame.markers.empty() || frame.markers.front().id != options.id) {
    return "marker " + std::to_string(options.id) + " is seen, but the points around it have no data";
  }
  frame.base_from_camera = markerPose(frame.floor, frame.markers.front());
  return "";
}

}  // namespace

BaseFrameResult findBaseFrame(const geometry::CloudView& cloud, BaseFrameSource source,
                              const DetectionOptions& options) {
  if (cloud.data == nullptr || cloud.width <= 0 || cloud.height <= 0) {
    throw std::invalid_argument("findBaseFrame: cloud: no data or no size (" + std::to_string(cloud.width) +
                                " x " + std::to_string(cloud.height) + " points)");
  }
  BaseFrameResult result;
  const PlaneResult plane = findLargestPlane(cloud, options.plane);
  if (!plane.fit) {
    result.message = plane.message;
    return result;
  }
  BaseFrame frame;
  frame.floor = plane.fit->plane;
  frame.plane_inliers = plane.fit->inliers;
  frame.plane_rms_m = plane.fit->rms_m;
  if (source == BaseFrameSource::kFloor) {
    frame.base_from_camera = floorPose(frame.floor);
  } else {
    result.message = useMarker(cloud, options.marker, frame);
    if (!result.message.empty()) return result;
  }
  result.frame = frame;
  return result;
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
