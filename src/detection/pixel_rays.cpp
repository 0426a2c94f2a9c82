#include "pixel_rays.hpp"

#include <cmath>

#include <Eigen/Dense>

namespace mixed_palletizing::detection {

void PixelRays::add(double col, double row, const Eigen::Vector3f& point) {
  if (count_++ == 0) shift_ = Eigen::Vector2d(col, row);
  const Eigen::Vector3d at(col - shift_.x(), row - shift_.y(), 1.0);
  const Eigen::Vector2d ray = (point.head<2>() / point.z()).cast<double>();
  squares_ += at * at.transpose();
  products_ += at * ray.transpose();
}

bool PixelRays::fit() {
  if (count_ < 3) return false;
  const double n = static_cast<double>(count_);
  const Eigen::Vector2d mean = squares_.block<2, 1>(0, 2) / n;
  const Eigen::Matrix2d spread = squares_.topLeftCorner<2, 2>() / n - mean * mean.transpose();
  if (!(spread.determinant() > 1e-6 * spread.trace() * spread.trace())) return false;
  model_ = squares_.ldlt().solve(products_);
  const Eigen::Matrix2d slope = model_.topRows<2>().transpose();
  if (!(std::abs(slope.determinant()) > 1e-18)) return false;
  inverse_ = slope.inverse();
  return true;
}

Eigen::Vector2d PixelRays::ray(double col, double row) const {
  return model_.transpose() * Eigen::Vector3d(col - shift_.x(), row - shift_.y(), 1.0);
}

std::optional<Eigen::Vector2d> PixelRays::pixel(const Eigen::Vector3d& point) const {
  if (!(point.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d ray = point.head<2>() / point.z();
  return shift_ + inverse_ * (ray - model_.row(2).transpose());
}

Eigen::Matrix3d PixelRays::projection() const {
  Eigen::Matrix3d p = Eigen::Matrix3d::Zero();
  p.topLeftCorner<2, 2>() = inverse_;
  p.block<2, 1>(0, 2) = shift_ - inverse_ * model_.row(2).transpose();
  p(2, 2) = 1.0;
  return p;
}

}  // namespace mixed_palletizing::detection
