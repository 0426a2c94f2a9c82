// Statistics of what the sensor does to the ideal cloud.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>

#include "counter_random.hpp"
#include "small_scenes.hpp"

namespace mixed_palletizing::simulation {
namespace {

struct Moments {
  double count = 0.0;
  double mean = 0.0;
  double stddev = 0.0;
};

Moments momentsOf(const std::vector<double>& values) {
  Moments m;
  m.count = static_cast<double>(values.size());
  for (const double v : values) m.mean += v / m.count;
  for (const double v : values) m.stddev += (v - m.mean) * (v - m.mean) / m.count;
  m.stddev = std::sqrt(m.stddev);
  return m;
}

TEST(CounterRandom, UniformAndGaussianHaveTheirMoments) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const CounterRandom random(seed);
    std::vector<double> uniform;
    std::vector<double> gaussian;
    std::size_t beyond_two = 0;
    for (std::uint64_t i = 0; i < 200000; ++i) {
      uniform.push_back(random.uniform(i, 0));
      gaussian.push_back(random.gaussian(i, 1));
      if (std::abs(gaussian.back()) > 2.0) ++beyond_two;
    }
    EXPECT_GT(*std::min_element(uniform.begin(), uniform.end()), 0.0);
    EXPECT_LT(*std::max_element(uniform.begin(), uniform.end()), 1.0);
    EXPECT_NEAR(momentsOf(uniform).mean, 0.5, 0.003);
    EXPECT_NEAR(momentsOf(uniform).stddev, std::sqrt(1.0 / 12.0), 0.003);
    EXPECT_NEAR(momentsOf(gaussian).mean, 0.0, 0.01);
    EXPECT_NEAR(momentsOf(gaussian).stddev, 1.0, 0.01);
    EXPECT_NEAR(static_cast<double>(beyond_two) / 200000.0, 0.0455, 0.003);
  }
}

TEST(Sensor, DepthNoiseGrowsWithTheSquareOfTheDepth) {
  constexpr double kStddev = 0.001;
  for (const double height : {0.5, 1.0, 2.0}) {
    Scene scene = bareFloor(height);
    scene.noise.depth_stddev_at_1m_m = kStddev;
    std::vector<double> errors;
    std::vector<double> products;  // of neighbours' errors: independent
    for (const geometry::ColoredPoint& point : capture(scene, 7).cloud.points) {
      errors.push_back(static_cast<double>(point.z) - height);
      if (errors.size() > 1) products.push_back(errors.back() * errors[errors.size() - 2]);
    }
    const double expected = kStddev * height * height;
    const Moments m = momentsOf(errors);
    EXPECT_NEAR(m.stddev, expected, 0.02 * expected) << height;
    EXPECT_NEAR(m.mean, 0.0, 4.0 * expected / std::sqrt(m.count)) << height;
    EXPECT_NEAR(momentsOf(products).mean, 0.0, 4.0 * expected * expected / std::sqrt(m.count)) << height;
  }
}

TEST(Sensor, DepthNoiseGrowsOnDarkAndGrazingSurfacesByOption) {
  constexpr double kStddev = 0.0005;
  for (const double luma : {0.2, 0.6, 1.0}) {
    for (const double tilt : {0.0, 0.8}) {
      Scene scene = bareFloor(1.0);
      scene.floor.rgb = static_cast<std::uint32_t>(std::lround(luma * 255.0)) * 0x010101u;
      scene.camera.horizontal_fov_rad = 0.02;  // one angle for the whole image
      scene.camera.world_from_camera = lookAt({std::sin(tilt), 0.0, std::cos(tilt)}, {0.0, 0.0, 0.0});
      const Capture ideal = capture(scene, 7);
      scene.noise.depth_stddev_at_1m_m = kStddev;
      scene.noise.dark_noise_gain = 3.0;
      scene.noise.grazing_noise_gain = 2.0;
      const Capture noisy = capture(scene, 7);
      std::vector<double> errors;
      for (std::size_t i = 0; i < ideal.cloud.points.size(); ++i) {
        errors.push_back(static_cast<double>(noisy.cloud.points[i].z - ideal.cloud.points[i].z));
      }
      const double expected =
          kStddev * (1.0 + 3.0 * (1.0 - luma)) * (1.0 + 2.0 * (1.0 / std::cos(tilt) - 1.0));
      EXPECT_NEAR(momentsOf(errors).stddev, expected, 0.03 * expected) << luma << " " << tilt;
    }
  }
}

TEST(Sensor, NoisyPointsStayOnTheirRay) {
  Scene scene = smallScene(3);
  scene.noise.depth_stddev_at_1m_m = 0.005;
  const Capture result = capture(scene, 3);
  const Pinhole pinhole(scene.camera);
  for (int row = 0; row < scene.camera.height_px; ++row) {
    for (int col = 0; col < scene.camera.width_px; ++col) {
      const geometry::ColoredPoint& point = result.cloud.points[pixelIndex(scene, row, col)];
      if (std::isnan(point.z)) continue;
      const Eigen::Vector2d image = pinhole.project({point.x, point.y, point.z});
      ASSERT_NEAR(image.x(), col, 1e-3);
      ASSERT_NEAR(image.y(), row, 1e-3);
    }
  }
}

TEST(Sensor, DropoutsHaveTheirShare) {
  for (const double ratio : {0.01, 0.3}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Scene scene = bareFloor(1.0);
      scene.noise.dropout_ratio = ratio;
      double missing = 0.0;
      const Capture result = capture(scene, seed);
      for (const geometry::ColoredPoint& point : result.cloud.points)
        missing += std::isnan(point.z) ? 1.0 : 0.0;
      const double count = static_cast<double>(result.cloud.points.size());
      EXPECT_NEAR(missing / count, ratio, 5.0 * std::sqrt(ratio * (1.0 - ratio) / count)) << "seed " << seed;
    }
  }
}

/// Least and greatest depth among a pixel and its four neighbours.
std::pair<double, double> depthsAround(const Scene& scene, const Capture& result, int row, int col) {
  std::pair<double, double> range(1e9, -1e9);
  for (const auto& [dr, dc] : {std::pair<int, int>{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    const int r = std::clamp(row + dr, 0, scene.camera.height_px - 1);
    const int c = std::clamp(col + dc, 0, scene.camera.width_px - 1);
    const double depth = result.cloud.points[pixelIndex(scene, r, c)].z;
    range.first = std::min(range.first, depth);
    range.second = std::max(range.second, depth);
  }
  return range;
}

TEST(Sensor, FlyingPixelsLieBetweenTheSidesOfADepthEdge) {
  constexpr double kRatio = 0.5;
  Scene scene = bareFloor(1.0);
  scene.boxes.resize(2);
  scene.boxes[0].position_m = {-0.2, 0.0};
  scene.boxes[0].size_m = {0.2, 0.2, 0.2};
  scene.boxes[1].position_m = {0.2, 0.0};
  scene.boxes[1].size_m = {0.2, 0.2, 0.01};  // too low for an edge
  const Capture ideal = capture(scene, 1);
  scene.noise.flying_pixel_ratio = kRatio;
  const Capture flying = capture(scene, 1);
  double edge = 0.0;
  double moved = 0.0;
  for (int row = 0; row < scene.camera.height_px; ++row) {
    for (int col = 0; col < scene.camera.width_px; ++col) {
      const std::size_t i = pixelIndex(scene, row, col);
      const auto [low, high] = depthsAround(scene, ideal, row, col);
      const double depth = flying.cloud.points[i].z;
      const bool is_moved = flying.cloud.points[i].z != ideal.cloud.points[i].z;
      const double own = ideal.cloud.points[i].z;
      if (std::max(high - own, own - low) < scene.noise.depth_edge_m) {
        ASSERT_FALSE(is_moved) << row << " " << col;
        continue;
      }
      ASSERT_GE(depth, low) << row << " " << col;
      ASSERT_LE(depth, high) << row << " " << col;
      edge += 1.0;
      moved += is_moved ? 1.0 : 0.0;
    }
  }
  ASSERT_GT(edge, 100.0);
  EXPECT_NEAR(moved / edge, kRatio, 5.0 * std::sqrt(kRatio * kRatio / edge));
  EXPECT_EQ(ideal.mask, flying.mask);
}

}  // namespace
}  // namespace mixed_palletizing::simulation
