// Viewing rays around a part of the image, in the base frame: from pixels to places at a height and back.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "base_cloud.hpp"
#include "pixel_rays.hpp"

namespace mixed_palletizing::detection {

/// Part of the image, ends included [px].
struct PixelBox {
  int row_min = 0, row_max = -1;
  int col_min = 0, col_max = -1;

  void include(const PixelBox& other);
  /// Grown on all sides, inside an image of that size.
  PixelBox grown(int margin, int width, int height) const;
};

/// From coordinates on a plane to pixels.
class LevelMap {
 public:
  LevelMap() = default;
  explicit LevelMap(const Eigen::Matrix3d& homography) : h_(homography.cast<float>()) {}

  /// Pixel that sees the place (u, v); false outside of an image of that size or behind the camera.
  bool pixel(float u, float v, int width, int height, int& col, int& row) const {
    const float w = h_(2, 0) * u + h_(2, 1) * v + h_(2, 2);
    if (!(w > 0.0f)) return false;
    const float x = (h_(0, 0) * u + h_(0, 1) * v + h_(0, 2)) / w + 0.5f;
    const float y = (h_(1, 0) * u + h_(1, 1) * v + h_(1, 2)) / w + 0.5f;
    if (!(x >= 0.0f && y >= 0.0f && x < static_cast<float>(width) && y < static_cast<float>(height)))
      return false;
    col = static_cast<int>(x);
    row = static_cast<int>(y);
    return true;
  }

  /// The same for `count` places at once; column and row are -1 where pixel() is false.
  void pixels(const float* u, const float* v, std::size_t count, int width, int height, int* cols,
              int* rows) const;

 private:
  Eigen::Matrix3f h_ = Eigen::Matrix3f::Zero();
};

class RayModel {
 public:
  /// Fits the rays of measured pixels in the box; false when they are too few.
  bool fit(const BaseCloud& cloud, const PixelBox& box);

  /// Ray through (column, row), whole numbers being the middle of a pixel; depth 1 along the optical axis.
  Eigen::Vector3d ray(double col, double row) const;

  /// Place where the ray through (column, row) reaches a height [m].
  Eigen::Vector2d placeAt(double col, double row, double height_m) const;

  /// (column, row) where a point of the base frame is seen; nothing for a point behind the camera.
  std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& point) const;

  /// Map of the plane of the places origin + u * along_u + v * along_v (base frame).
  LevelMap levelMap(const Eigen::Vector3d& origin, const Eigen::Vector3d& along_u,
                    const Eigen::Vector3d& along_v) const;

 private:
  PixelRays rays_;
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d camera_ = Eigen::Vector3d::Zero();
};

}  // namespace mixed_palletizing::detection
