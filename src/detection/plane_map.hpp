// Coordinates on a plane that a camera looks at, and the pixels where its points are seen.
#pragma once

#include <optional>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/plane.hpp>

#include "lens_rays.hpp"

namespace mixed_palletizing::detection {

/// Right-handed coordinates on a plane, its normal pointing to the camera: seen from the camera they turn as drawn on
/// paper, y to the left of x. The origin is the foot of the camera's perpendicular.
struct PlaneAxes {
  explicit PlaneAxes(const geometry::Plane& plane_in_camera);

  Eigen::Vector3d inCamera(const Eigen::Vector2d& point) const {
    return origin + x * point.x() + y * point.y();
  }
  Eigen::Vector2d onPlane(const Eigen::Vector3d& p) const { return {x.dot(p - origin), y.dot(p - origin)}; }

  geometry::Plane plane;
  Eigen::Vector3d origin;  ///< camera frame
  Eigen::Vector3d x;
  Eigen::Vector3d y;
};

/// Carries pixels onto a plane and back.
struct PlaneMap {
  PlaneAxes axes;
  LensRays rays;

  /// Point of the plane that a pixel sees; nothing when its ray does not meet the plane in front of the camera.
  std::optional<Eigen::Vector2d> point(const Eigen::Vector2d& pixel) const;

  /// Pixel where a point of the plane is seen.
  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector2d& point) const {
    return rays.pixel(axes.inCamera(point));
  }
};

}  // namespace mixed_palletizing::detection
