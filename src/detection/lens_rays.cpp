#include "lens_rays.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace mixed_palletizing::detection {
namespace {

constexpr double kSamplesPerSide = 150.0;  // of the window: more do not make the model better
constexpr int kFewest = 60;
constexpr double kSmallestSpread = 1e-3;  // of the scaled pixels: thinner point sets do not surround an area
constexpr int kNewtonSteps = 4;

}  // namespace

LensRays::Terms LensRays::terms(const Eigen::Vector2d& at) const {
  const Eigen::Vector2d s = (at - middle_) / scale_;
  Terms t;
  t << 1.0, s.x(), s.y(), s.x() * s.x(), s.x() * s.y(), s.y() * s.y();
  return t;
}

Eigen::Matrix2d LensRays::slope(const Eigen::Vector2d& at) const {
  const Eigen::Vector2d s = (at - middle_) / scale_;
  Eigen::Matrix<double, kTerms, 2> derivative;
  derivative << 0, 0, 1, 0, 0, 1, 2 * s.x(), 0, s.y(), s.x(), 0, 2 * s.y();
  return model_ * derivative / scale_;
}

std::optional<LensRays> LensRays::fit(const geometry::CloudView& cloud, const PixelWindow& window) {
  LensRays rays;
  const int width = window.col_end - window.col_begin;
  const int height = window.row_end - window.row_begin;
  rays.middle_ = {0.5 * (window.col_begin + window.col_end), 0.5 * (window.row_begin + window.row_end)};
  rays.scale_ = std::max(1.0, 0.5 * std::max(width, height));
  const int step = std::max(1, static_cast<int>(std::max(width, height) / kSamplesPerSide));
  Eigen::Matrix<double, kTerms, kTerms> squares = Eigen::Matrix<double, kTerms, kTerms>::Zero();
  Eigen::Matrix<double, kTerms, 2> products = Eigen::Matrix<double, kTerms, 2>::Zero();
  int count = 0;
  for (int row = window.row_begin; row < window.row_end; row += step) {
    for (int col = window.col_begin; col < window.col_end; col += step) {
      const Eigen::Vector3f p = cloud.point(row, col);
      if (!(p.z() > 0.0f) || !p.allFinite()) continue;
      const Terms t = rays.terms(Eigen::Vector2d(col, row));
      squares += t * t.transpose();
      products += t * (p.head<2>().cast<double>() / static_cast<double>(p.z())).transpose();
      ++count;
    }
  }
  if (count < kFewest) return std::nullopt;
  const Eigen::Vector2d mean = squares.block<1, 2>(0, 1).transpose() / count;
  const Eigen::Matrix2d spread =
      (Eigen::Matrix2d() << squares(0, 3), squares(0, 4), squares(0, 4), squares(0, 5)).finished() / count -
      mean * mean.transpose();
  if (!(spread.determinant() > kSmallestSpread * kSmallestSpread)) return std::nullopt;
  rays.model_ = squares.ldlt().solve(products).transpose();
  if (!(std::abs(rays.slope(rays.middle_).determinant()) > 1e-18)) return std::nullopt;
  return rays;
}

Eigen::Vector3d LensRays::ray(const Eigen::Vector2d& pixel) const {
  return (model_ * terms(pixel)).homogeneous();
}

std::optional<Eigen::Vector2d> LensRays::pixel(const Eigen::Vector3d& point) const {
  if (!(point.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d wanted = point.head<2>() / point.z();
  Eigen::Vector2d at = middle_;
  for (int i = 0; i < kNewtonSteps; ++i) {
    at += slope(at).partialPivLu().solve(wanted - ray(at).head<2>());
  }
  if (!at.allFinite()) return std::nullopt;
  return at;
}

}  // namespace mixed_palletizing::detection
