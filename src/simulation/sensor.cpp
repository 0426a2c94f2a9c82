#include "sensor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mixed_palletizing::simulation {
namespace {

/// Streams of the random numbers of a pixel.
enum Stream : std::uint32_t { kDropout = 0, kFlying = 1, kFlyingPlace = 2, kDepth = 3 };

/// Ink below this luma sends too little of the projector's light back.
constexpr float kDarkLuma = 0.2f;

constexpr double kLeastCosine = 0.05;

}  // namespace

Sensor::Sensor(const Noise& noise, int width, int height, std::uint64_t seed)
    : noise_(noise), width_(width), height_(height), random_(seed) {}

double Sensor::measuredDepth(const std::vector<Sample>& samples, int row, int col) const {
  constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();
  const auto index =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(col);
  const Sample& sample = samples[index];
  if (sample.object < 0 || !sample.is_lit) return kNoData;
  if (noise_.no_data_on_black && sample.luma < kDarkLuma) return kNoData;
  if (noise_.dropout_ratio > 0.0 && random_.uniform(index, kDropout) < noise_.dropout_ratio) return kNoData;
  double depth = sample.depth_m;
  if (noise_.flying_pixel_ratio > 0.0 && random_.uniform(index, kFlying) < noise_.flying_pixel_ratio) {
    depth = flyingDepth(samples, row, col);
  }
  if (noise_.depth_stddev_at_1m_m > 0.0) {
    depth += depthStddev(sample, depth) * random_.gaussian(index, kDepth);
  }
  return depth > 0.0 ? depth : kNoData;
}

double Sensor::depthStddev(const Sample& sample, double depth) const {
  const double cosine = std::max(static_cast<double>(sample.cosine), kLeastCosine);
  const double dark = 1.0 + noise_.dark_noise_gain * (1.0 - static_cast<double>(sample.luma));
  const double grazing = 1.0 + noise_.grazing_noise_gain * (1.0 / cosine - 1.0);
  return noise_.depth_stddev_at_1m_m * depth * depth * dark * grazing;
}

/// A depth between the pixel's own and the neighbour's that differs most; its own when there is no edge.
double Sensor::flyingDepth(const std::vector<Sample>& samples, int row, int col) const {
  const auto at = [&](int r, int c) -> const Sample& {
    return samples[static_cast<std::size_t>(r) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(c)];
  };
  const double own = at(row, col).depth_m;
  double largest_step = 0.0;
  for (const auto& [dr, dc] : {std::array<int, 2>{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    const int r = row + dr;
    const int c = col + dc;
    if (r < 0 || c < 0 || r >= height_ || c >= width_ || at(r, c).object < 0) continue;
    const double step = at(r, c).depth_m - own;
    if (std::abs(step) > std::abs(largest_step)) largest_step = step;
  }
  if (std::abs(largest_step) < noise_.depth_edge_m) return own;
  const auto index =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(col);
  return own + largest_step * random_.uniform(index, kFlyingPlace);
}

}  // namespace mixed_palletizing::simulation
