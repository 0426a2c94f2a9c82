#include "ray_model.hpp"

#include <algorithm>

namespace mixed_palletizing::detection {
namespace {

constexpr int kSamplesPerSide = 24;
constexpr std::size_t kEnough = 12;

}  // namespace

void PixelBox::include(const PixelBox& other) {
  if (other.row_max < other.row_min) return;
  if (row_max < row_min) {
    *this = other;
    return;
  }
  row_min = std::min(row_min, other.row_min);
  row_max = std::max(row_max, other.row_max);
  col_min = std::min(col_min, other.col_min);
  col_max = std::max(col_max, other.col_max);
}

PixelBox PixelBox::grown(int margin, int width, int height) const {
  return {std::max(0, row_min - margin), std::min(height - 1, row_max + margin),
          std::max(0, col_min - margin), std::min(width - 1, col_max + margin)};
}

bool RayModel::fit(const BaseCloud& cloud, const PixelBox& box) {
  rays_ = PixelRays();
  rotation_ = cloud.rotation().cast<double>();
  camera_ = cloud.camera();
  const int row_step = std::max(1, (box.row_max - box.row_min) / kSamplesPerSide);
  const int col_step = std::max(1, (box.col_max - box.col_min) / kSamplesPerSide);
  for (int row = box.row_min; row <= box.row_max; row += row_step) {
    for (int col = box.col_min; col <= box.col_max; col += col_step) {
      if (cloud.valid(row, col)) rays_.add(col, row, cloud.view().point(row, col));
    }
  }
  return rays_.count() >= kEnough && rays_.fit();
}

Eigen::Vector3d RayModel::ray(double col, double row) const {
  const Eigen::Vector2d ray = rays_.ray(col, row);
  return rotation_ * Eigen::Vector3d(ray.x(), ray.y(), 1.0);
}

Eigen::Vector2d RayModel::placeAt(double col, double row, double height_m) const {
  const Eigen::Vector3d direction = ray(col, row);
  return (camera_ + (height_m - camera_.z()) / direction.z() * direction).head<2>();
}

std::optional<Eigen::Vector2d> RayModel::pixelOf(const Eigen::Vector3d& point) const {
  return rays_.pixel(rotation_.transpose() * (point - camera_));
}

LevelMap RayModel::levelMap(const Eigen::Vector3d& origin, const Eigen::Vector3d& along_u,
                            const Eigen::Vector3d& along_v) const {
  Eigen::Matrix3d frame;
  frame << along_u, along_v, origin - camera_;
  return LevelMap(rays_.projection() * rotation_.transpose() * frame);
}

}  // namespace mixed_palletizing::detection
