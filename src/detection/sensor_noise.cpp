#include "sensor_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mixed_palletizing::detection {
namespace {

constexpr int kSamplesPerSide = 96;
constexpr std::size_t kEnough = 50;
constexpr double kFloorShare = 0.05;             // of all samples: less floor says nothing about the floor
constexpr double kNormalMedian = 0.6745;         // median of |x| for a standard normal x
constexpr double kNormalQuarter = 0.3186;        // lower quartile of |x|
constexpr double kSlack = 1.1;                   // of the measured depth noise, before the rest is ripple
constexpr double kSecondDifference = 2.4494897;  // sqrt(1 + 4 + 1): stddev of a - 2 b + c

/// The value below which `share` of the samples lie; 0 for too few samples.
double quantile(std::vector<double>& samples, double share) {
  if (samples.size() < kEnough) return 0.0;
  const auto at = samples.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(samples.size()));
  std::nth_element(samples.begin(), at, samples.end());
  return *at;
}

/// What a standard deviation holds beyond another, independent one.
double excess(double stddev, double other) {
  return std::sqrt(std::max(0.0, stddev * stddev - other * other));
}

struct Samples {
  std::vector<double> along_row, along_column, second_difference, height, depth;
  double floor_gain_squares = 0.0;  // of the floor samples: (height error over depth error at 1 m)^2
  std::size_t valid = 0;
};

void sampleAt(const BaseCloud& cloud, int row, int col, double floor_band_m, Samples& samples) {
  if (!cloud.valid(row, col)) return;
  ++samples.valid;
  const Eigen::Vector3d ray = cloud.ray(row, col);
  const double depth = static_cast<double>(cloud.view().point(row, col).z());
  samples.depth.push_back(depth);
  const double height = std::abs(cloud.point(row, col).z());
  if (height < floor_band_m) {
    samples.height.push_back(height);
    const double gain = ray.z() * depth * depth;
    samples.floor_gain_squares += gain * gain;
  }
  if (row + 1 < cloud.height() && cloud.valid(row + 1, col)) {
    samples.along_column.push_back((cloud.ray(row + 1, col) - ray).norm());
  }
  if (col + 1 >= cloud.width() || !cloud.valid(row, col + 1)) return;
  samples.along_row.push_back((cloud.ray(row, col + 1) - ray).norm());
  if (col == 0 || !cloud.valid(row, col - 1)) return;
  const double before = cloud.view().point(row, col - 1).z();
  const double here = cloud.view().point(row, col).z();
  const double after = cloud.view().point(row, col + 1).z();
  samples.second_difference.push_back(std::abs(before - 2.0 * here + after) / (here * here));
}

}  // namespace

SensorNoise measureNoise(const BaseCloud& cloud, double floor_band_m) {
  Samples samples;
  const int row_step = std::max(1, cloud.height() / kSamplesPerSide);
  const int col_step = std::max(1, cloud.width() / kSamplesPerSide);
  const auto most =
      static_cast<std::size_t>((cloud.height() / row_step + 1) * (cloud.width() / col_step + 1));
  for (auto* values : {&samples.along_row, &samples.along_column, &samples.second_difference, &samples.height,
                       &samples.depth}) {
    values->reserve(most);
  }
  for (int row = 0; row < cloud.height(); row += row_step) {
    for (int col = 0; col < cloud.width(); col += col_step) {
      sampleAt(cloud, row, col, floor_band_m, samples);
    }
  }
  SensorNoise noise;
  noise.spacing_per_m = std::max(quantile(samples.along_row, 0.5), quantile(samples.along_column, 0.5));
  noise.depth_per_m2 = quantile(samples.second_difference, 0.5) / (kNormalMedian * kSecondDifference);
  if (samples.depth.size() >= kEnough) noise.scene_depth_m = quantile(samples.depth, 0.5);
  // The lower quartile holds even when most of the band is something other than floor.
  if (static_cast<double>(samples.height.size()) > kFloorShare * static_cast<double>(samples.valid)) {
    const double gain = std::sqrt(samples.floor_gain_squares / static_cast<double>(samples.height.size()));
    noise.floor_stddev_m = quantile(samples.height, 0.25) / kNormalQuarter;
    noise.ripple_m = excess(noise.floor_stddev_m, kSlack * gain * noise.depth_per_m2);
  }
  return noise;
}

}  // namespace mixed_palletizing::detection
