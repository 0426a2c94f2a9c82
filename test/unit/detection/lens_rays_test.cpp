#include "lens_rays.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/organized_cloud.hpp>

namespace mixed_palletizing::detection {
namespace {

/// Points at random depths on the rays of a camera whose lens bends them by `k` r^2.
geometry::OrganizedCloud bentCloud(double focal, double k, std::mt19937& rng) {
  std::uniform_real_distribution<double> depth(0.8, 1.6);
  geometry::OrganizedCloud cloud;
  cloud.width = 320;
  cloud.height = 200;
  for (int row = 0; row < cloud.height; ++row) {
    for (int col = 0; col < cloud.width; ++col) {
      const Eigen::Vector2d flat((col - 700.0) / focal,
                                 (row + 300.0) / focal);  // far from the middle of the lens
      const Eigen::Vector2d ray = flat * (1.0 + k * flat.squaredNorm());
      const double z = depth(rng);
      cloud.points.push_back(
          {static_cast<float>(z * ray.x()), static_cast<float>(z * ray.y()), static_cast<float>(z), 0});
    }
  }
  return cloud;
}

TEST(LensRays, followABentLensAcrossAHole) {
  std::mt19937 rng(61);
  auto cloud = bentCloud(2700.0, -0.15, rng);
  for (int row = 60; row < 140; ++row) {
    for (int col = 100; col < 220; ++col) cloud.points[static_cast<std::size_t>(row * 320 + col)] = {};
  }
  const auto rays = LensRays::fit(cloud.view(), {0, 0, 320, 200});
  ASSERT_TRUE(rays);
  const Eigen::Vector2d at(160.3, 99.7);
  const Eigen::Vector2d flat((at.x() - 700.0) / 2700.0, (at.y() + 300.0) / 2700.0);
  const Eigen::Vector2d truth = flat * (1.0 - 0.15 * flat.squaredNorm());
  EXPECT_LT((rays->ray(at).head<2>() - truth).norm(), 2e-5);  // 20 um at 1 m
  const auto pixel = rays->pixel(1.3 * rays->ray(at));
  ASSERT_TRUE(pixel);
  EXPECT_LT((*pixel - at).norm(), 1e-6);
  EXPECT_FALSE(rays->pixel({0.1, 0.1, -1.0}));
}

TEST(LensRays, needPointsThatSurroundAnArea) {
  geometry::OrganizedCloud cloud;
  cloud.width = 100;
  cloud.height = 100;
  cloud.points.resize(10000);
  EXPECT_FALSE(LensRays::fit(cloud.view(), {0, 0, 100, 100}));
  for (int col = 0; col < 100; ++col) {
    cloud.points[static_cast<std::size_t>(50 * 100 + col)] = {0.001f * static_cast<float>(col), 0.05f, 1.0f,
                                                              0};
  }
  EXPECT_FALSE(LensRays::fit(cloud.view(), {0, 0, 100, 100}));
}

}  // namespace
}  // namespace mixed_palletizing::detection
