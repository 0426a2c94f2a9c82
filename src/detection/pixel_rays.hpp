// Viewing rays of pixels, also of those without data, from the rays of measured pixels around them.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace mixed_palletizing::detection {

/// Linear model x / z, y / z over (column, row), fitted to points in the camera frame: exact for a pinhole
/// camera, and close in a small window of any other. No CameraInfo is needed.
class PixelRays {
 public:
  /// A measured point at a pixel; z must be positive.
  void add(double col, double row, const Eigen::Vector3f& point);

  std::size_t count() const { return count_; }

  /// Fits the model. False when the pixels are fewer than 3 or on one line, or when all rays are one.
  bool fit();

  /// (x / z, y / z) of the ray through (column, row), whole numbers being the middle of a pixel. After fit().
  Eigen::Vector2d ray(double col, double row) const;

  /// (column, row) where a point of the camera frame is seen; nothing for a point behind the camera.
  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& point) const;

  /// The same as a projection: (column, row, 1) times depth = projection() * point.
  Eigen::Matrix3d projection() const;

 private:
  std::size_t count_ = 0;
  Eigen::Vector2d shift_ = Eigen::Vector2d::Zero();  // the first pixel: keeps the sums small
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> products_ = Eigen::Matrix<double, 3, 2>::Zero();
  Eigen::Matrix<double, 3, 2> model_ = Eigen::Matrix<double, 3, 2>::Zero();
  Eigen::Matrix2d inverse_ = Eigen::Matrix2d::Zero();
};

}  // namespace mixed_palletizing::detection
