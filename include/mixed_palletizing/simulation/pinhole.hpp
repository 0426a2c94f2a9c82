// The projection of a scene's camera.
#pragma once

#include <Eigen/Core>

#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

/// Pinhole without distortion, square pixels, the optical axis through the middle of the image. Pixel
/// (row, col) is a point: its centre has the image coordinates (u, v) = (col, row).
struct Pinhole {
  double focal_px = 1.0;
  double cx_px = 0.0;
  double cy_px = 0.0;

  explicit Pinhole(const Camera& camera);

  /// Direction of the ray through (u, v) in the optical frame with z = 1: a point at depth z [m] is z * ray.
  Eigen::Vector3d ray(double u, double v) const {
    return {(u - cx_px) / focal_px, (v - cy_px) / focal_px, 1.0};
  }

  /// Image coordinates of a point of the optical frame with z > 0.
  Eigen::Vector2d project(const Eigen::Vector3d& point) const {
    return {focal_px * point.x() / point.z() + cx_px, focal_px * point.y() / point.z() + cy_px};
  }
};

}  // namespace mixed_palletizing::simulation
