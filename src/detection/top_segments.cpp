#include "top_segments.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace mixed_palletizing::detection {
namespace {

constexpr int kLargestReach = 6;
constexpr double kUsualSlope = 0.02;  // of a top
constexpr double kSlackSigmas = 2.0;  // of the noise that two heights of one surface may differ
constexpr double kSlopeSigmas = 3.0;  // of the noise that a slope's measurement covers
constexpr std::array<std::array<int, 2>, 4> kNeighbors{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};

/// Plane through the cells by least squares, with the tops' slope known beforehand to be about 0: a sensor whose errors
/// are shared by neighbours (ripple) shows slopes where there are none.
void fitPlane(const HeightRaster& raster, const SegmentLimits& limits, TopSegment& segment) {
  const auto placeOf = [&](std::size_t cell) {
    const int row = static_cast<int>(cell / static_cast<std::size_t>(raster.cols()));
    return raster.place(row, static_cast<int>(cell % static_cast<std::size_t>(raster.cols())));
  };
  const double n = static_cast<double>(segment.cells.size());
  segment.center.setZero();
  segment.height_m = 0.0;
  for (const std::size_t cell : segment.cells) {
    segment.center += placeOf(cell) / n;
    segment.height_m += static_cast<double>(raster.height(cell)) / n;
  }
  const double doubt = limits.ripple_m / kUsualSlope;
  Eigen::Matrix2d squares = (1e-12 + n * doubt * doubt) * Eigen::Matrix2d::Identity();
  Eigen::Vector2d products = Eigen::Vector2d::Zero();
  for (const std::size_t cell : segment.cells) {
    const Eigen::Vector2d d = placeOf(cell) - segment.center;
    squares += d * d.transpose();
    products += d * (static_cast<double>(raster.height(cell)) - segment.height_m);
  }
  segment.slope = squares.ldlt().solve(products);
  double sum = 0.0;
  for (const std::size_t cell : segment.cells) {
    const double error = static_cast<double>(raster.height(cell)) - segment.heightAt(placeOf(cell));
    sum += error * error / n;
  }
  segment.rms_m = std::sqrt(sum);
}

}  // namespace

void TopSegments::markLevel(const HeightRaster& raster, const SegmentLimits& limits) {
  level_.assign(raster.size(), false);
  const double noise_reach = kSlopeSigmas * limits.noise_m / (limits.max_slope * raster.cell());
  reach_ = std::clamp(static_cast<int>(std::ceil(noise_reach)), 2, kLargestReach);
  const double most = limits.max_slope * reach_ * raster.cell() + kSlackSigmas * limits.noise_m;
  for (int row = reach_; row + reach_ < raster.rows(); ++row) {
    for (int col = reach_; col + reach_ < raster.cols(); ++col) {
      const std::size_t cell = raster.index(row, col);
      if (std::isnan(raster.height(cell))) continue;
      bool level = true;
      int measured = 0;
      for (std::size_t k = 0; k < 2 && level; ++k) {
        const float ahead =
            raster.height(raster.index(row + kNeighbors[k][0] * reach_, col + kNeighbors[k][1] * reach_));
        const float behind =
            raster.height(raster.index(row - kNeighbors[k][0] * reach_, col - kNeighbors[k][1] * reach_));
        const float here = raster.height(cell);
        if (!std::isnan(ahead)) level = level && std::abs(static_cast<double>(ahead - here)) < most;
        if (!std::isnan(behind)) level = level && std::abs(static_cast<double>(behind - here)) < most;
        measured += (std::isnan(ahead) ? 0 : 1) + (std::isnan(behind) ? 0 : 1);
      }
      level_[cell] = level && measured >= 2;
    }
  }
}

void TopSegments::grow(const HeightRaster& raster, const SegmentLimits& limits, std::size_t seed) {
  const int number = static_cast<int>(segments_.size());
  TopSegment segment;
  segment.cells.push_back(seed);
  labels_[seed] = number;
  for (std::size_t i = 0; i < segment.cells.size(); ++i) {
    const std::size_t cell = segment.cells[i];
    const int row = static_cast<int>(cell / static_cast<std::size_t>(raster.cols()));
    const int col = static_cast<int>(cell % static_cast<std::size_t>(raster.cols()));
    for (const auto& step : kNeighbors) {
      if (!raster.holds(row + step[0], col + step[1])) continue;
      const std::size_t other = raster.index(row + step[0], col + step[1]);
      if (!level_[other] || labels_[other] >= 0) continue;
      const double rise = std::abs(static_cast<double>(raster.height(other) - raster.height(cell)));
      if (rise > 0.5 * limits.step_m + limits.noise_m) continue;
      labels_[other] = number;
      segment.cells.push_back(other);
    }
  }
  const double area = static_cast<double>(segment.cells.size()) * raster.cell() * raster.cell();
  if (area < limits.min_area_m2) {
    for (const std::size_t cell : segment.cells) labels_[cell] = -2;  // seen, too small
    return;
  }
  fitPlane(raster, limits, segment);
  segments_.push_back(std::move(segment));
}

/// The cells at the border, which are not level themselves, as far as they lie on the segment's plane.
void TopSegments::widen(const HeightRaster& raster, const SegmentLimits& limits) {
  for (std::size_t number = 0; number < segments_.size(); ++number) {
    TopSegment& segment = segments_[number];
    std::size_t begin = 0;
    for (int round = 0; round < reach_ + 1; ++round) {
      const std::size_t end = segment.cells.size();
      for (std::size_t i = begin; i < end; ++i) {
        const int row = static_cast<int>(segment.cells[i] / static_cast<std::size_t>(raster.cols()));
        const int col = static_cast<int>(segment.cells[i] % static_cast<std::size_t>(raster.cols()));
        for (const auto& step : kNeighbors) {
          if (!raster.holds(row + step[0], col + step[1])) continue;
          const std::size_t other = raster.index(row + step[0], col + step[1]);
          if (labels_[other] >= 0 || std::isnan(raster.height(other))) continue;
          const double error = static_cast<double>(raster.height(other)) -
                               segment.heightAt(raster.place(row + step[0], col + step[1]));
          if (std::abs(error) > limits.step_m + 2.0 * limits.noise_m) continue;
          labels_[other] = static_cast<int>(number);
          segment.cells.push_back(other);
        }
      }
      begin = round == 0 ? 0 : end;
    }
  }
}

void TopSegments::find(const HeightRaster& raster, const SegmentLimits& limits) {
  segments_.clear();
  labels_.assign(raster.size(), -1);
  markLevel(raster, limits);
  for (std::size_t cell = 0; cell < raster.size(); ++cell) {
    if (level_[cell] && labels_[cell] == -1) grow(raster, limits, cell);
  }
  widen(raster, limits);
}

}  // namespace mixed_palletizing::detection
