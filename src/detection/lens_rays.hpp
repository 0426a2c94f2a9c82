// Viewing rays of pixels from the measured pixels around them, for lenses that bend straight lines.
#pragma once

#include <optional>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/cloud_view.hpp>

namespace mixed_palletizing::detection {

/// Part of the grid: rows [row_begin, row_end), columns [col_begin, col_end).
struct PixelWindow {
  int col_begin = 0;
  int row_begin = 0;
  int col_end = 0;
  int row_end = 0;
};

/// Quadratic model x / z, y / z over (column, row), fitted to the points with data of a window: exact for a pinhole
/// camera, and what is left of a lens' distortion in a window of some hundred pixels is of third order. Needs no
/// CameraInfo. Depth noise lies along the rays and does not disturb it.
class LensRays {
 public:
  /// Nothing when the points are too few or do not surround an area.
  static std::optional<LensRays> fit(const geometry::CloudView& cloud, const PixelWindow& window);

  /// (x / z, y / z, 1) of the ray through (column, row), whole numbers being the middle of a pixel.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;

  /// (column, row) where a point of the camera frame is seen; nothing for a point behind the camera.
  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& point) const;

 private:
  static constexpr int kTerms = 6;
  using Terms = Eigen::Matrix<double, kTerms, 1>;

  Terms terms(const Eigen::Vector2d& at) const;  // 1, u, v, u^2, u v, v^2 of the scaled pixel
  Eigen::Matrix2d slope(const Eigen::Vector2d& at) const;

  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
  double scale_ = 1.0;
  Eigen::Matrix<double, 2, kTerms> model_ = Eigen::Matrix<double, 2, kTerms>::Zero();
};

}  // namespace mixed_palletizing::detection
