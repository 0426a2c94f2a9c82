// The projection of a scene's camera.
#pragma once

#include <Eigen/Core>

#include <mixed_palletizing/simulation/camera.hpp>

namespace mixed_palletizing::simulation {

/// Pinhole without distortion. Pixel (row, col) is a point: its centre has the image coordinates
/// (u, v) = (col, row). Without intrinsics of its own the camera has square pixels and the optical axis runs
/// through the middle of the image.
struct Pinhole {
  double fx_px = 1.0;
  double fy_px = 1.0;
  double cx_px = 0.0;
  double cy_px = 0.0;

  explicit Pinhole(const Camera& camera);

  /// Direction of the ray through (u, v) in the optical frame with z = 1: a point at depth z [m] is z * ray.
  Eigen::Vector3d ray(double u, double v) const { return {(u - cx_px) / fx_px, (v - cy_px) / fy_px, 1.0}; }

  /// Image coordinates of a point of the optical frame with z > 0.
  Eigen::Vector2d project(const Eigen::Vector3d& point) const {
    return {fx_px * point.x() / point.z() + cx_px, fy_px * point.y() / point.z() + cy_px};
  }
};

}  // namespace mixed_palletizing::simulation
