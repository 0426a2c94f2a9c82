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

void LevelMap::pixels(const float* u, const float* v, std::size_t count, int width, int height, int* cols,
                      int* rows) const {
  const Eigen::Matrix3f h = h_;
  const auto right = static_cast<float>(width);
  const auto bottom = static_cast<float>(height);
  for (std::size_t i = 0; i < count; ++i) {
    const float w = h(2, 0) * u[i] + h(2, 1) * v[i] + h(2, 2);
    const float x = (h(0, 0) * u[i] + h(0, 1) * v[i] + h(0, 2)) / w + 0.5f;
    const float y = (h(1, 0) * u[i] + h(1, 1) * v[i] + h(1, 2)) / w + 0.5f;
    // Without branches, so that several places are computed at once.
    const bool seen = (w > 0.0f) & (x >= 0.0f) & (y >= 0.0f) & (x < right) & (y < bottom);
    cols[i] = static_cast<int>(seen ? x : -1.0f);
    rows[i] = static_cast<int>(seen ? y : -1.0f);
  }
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
