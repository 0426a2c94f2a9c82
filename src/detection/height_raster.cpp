#include "height_raster.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

constexpr int kLargestSide = 4000;  // cells: a stack in more is cut off
constexpr int kClosingRounds = 2;
constexpr int kFewestNeighbors = 4;  // with data, of eight, around a hole that is closed

/// Calls visit(row, col, point in the base frame) for every point of the stack.
template <typename Visit>
void forEachPoint(const BaseCloud& cloud, const WorkRegion& region, const RasterLimits& limits, Visit visit) {
  const auto low = static_cast<float>(limits.low_m);
  const auto high = static_cast<float>(limits.high_m);
  for (int row = 0; row < cloud.height(); ++row) {
    for (int col = 0; col < cloud.width(); ++col) {
      if (!cloud.valid(row, col)) continue;
      const Eigen::Vector3f p = cloud.point(row, col);
      const bool inside = p.z() > low && p.z() < high && (!region.limited() || region.contains(p));
      visit(row, col, p, inside);
    }
  }
}

float grayOf(const BaseCloud& cloud, int row, int col) {
  if (!cloud.view().hasColor()) return 0.0f;
  const std::uint8_t* bgr = cloud.view().bgr(row, col);
  return 0.114f * static_cast<float>(bgr[0]) + 0.587f * static_cast<float>(bgr[1]) +
         0.299f * static_cast<float>(bgr[2]);
}

}  // namespace

void HeightRaster::findBounds(const BaseCloud& cloud, const WorkRegion& region, const RasterLimits& limits) {
  valid_ = 0;
  low_.setConstant(std::numeric_limits<float>::infinity());
  high_ = -low_;
  forEachPoint(cloud, region, limits, [&](int, int, const Eigen::Vector3f& p, bool inside) {
    ++valid_;
    if (!inside) return;
    low_ = low_.min(p.head<2>().array());
    high_ = high_.max(p.head<2>().array());
  });
}

std::size_t HeightRaster::fill(const BaseCloud& cloud, const WorkRegion& region, const RasterLimits& limits) {
  findBounds(cloud, region, limits);
  cell_m_ = limits.cell_m;
  low_limit_m_ = limits.low_m;
  rows_ = cols_ = 0;
  if ((high_ >= low_).all()) {
    const Eigen::Array2d extent = (high_ - low_).cast<double>() / cell_m_;
    cols_ = std::min(kLargestSide, static_cast<int>(extent.x()) + 3);
    rows_ = std::min(kLargestSide, static_cast<int>(extent.y()) + 3);
    origin_ = low_.cast<double>().matrix() - Eigen::Vector2d::Constant(cell_m_);
  }
  const std::size_t count = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(cols_);
  heights_.assign(count, kNone);
  grays_.assign(count, kNone);
  forEachPoint(cloud, region, limits, [&](int row, int col, const Eigen::Vector3f& p, bool inside) {
    if (!inside) return;
    const Eigen::Vector2d at = gridOf(p.head<2>().cast<double>());
    const int r = static_cast<int>(std::lround(at.y()));
    const int c = static_cast<int>(std::lround(at.x()));
    if (!holds(r, c)) return;
    const std::size_t cell = index(r, c);
    if (heights_[cell] >= p.z()) return;
    heights_[cell] = p.z();
    grays_[cell] = grayOf(cloud, row, col);
  });
  closeHoles();
  return valid_;
}

void HeightRaster::closeHoles() {
  for (int round = 0; round < kClosingRounds; ++round) {
    const std::vector<float> before = heights_;
    const std::vector<float> grays_before = grays_;
    for (int row = 1; row + 1 < rows_; ++row) {
      for (int col = 1; col + 1 < cols_; ++col) {
        const std::size_t cell = index(row, col);
        if (!std::isnan(before[cell])) continue;
        float sum = 0.0f, gray = 0.0f;
        int n = 0;
        for (int k = 0; k < 9; ++k) {
          const std::size_t other = index(row + k / 3 - 1, col + k % 3 - 1);
          if (std::isnan(before[other])) continue;
          sum += before[other];
          gray += grays_before[other];
          ++n;
        }
        if (n < kFewestNeighbors) continue;
        heights_[cell] = sum / static_cast<float>(n);
        grays_[cell] = gray / static_cast<float>(n);
      }
    }
  }
}

}  // namespace mixed_palletizing::detection
