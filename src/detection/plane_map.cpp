#include "plane_map.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {

PlaneAxes::PlaneAxes(const geometry::Plane& plane_in_camera)
    : plane(plane_in_camera.facing(Eigen::Vector3d::Zero())), origin(-plane.offset * plane.normal) {
  // The camera's x on the plane; its y where the camera's x stands upright.
  const Eigen::Matrix3d level = geometry::alignVectors(plane.normal, Eigen::Vector3d::UnitZ());
  Eigen::Vector3d seen = level.col(0);
  if (seen.head<2>().norm() < 1e-6) seen = level.col(1);
  x = level.transpose() * Eigen::Vector3d(seen.x(), seen.y(), 0.0).normalized();
  y = plane.normal.cross(x);
}

std::optional<Eigen::Vector2d> PlaneMap::point(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector3d ray = rays.ray(pixel);
  const double slope = axes.plane.normal.dot(ray);
  if (!(std::abs(slope) > 1e-6)) return std::nullopt;
  const double depth = -axes.plane.offset / slope;
  if (!(depth > 0.0)) return std::nullopt;
  return axes.onPlane(depth * ray);
}

}  // namespace mixed_palletizing::detection
