#include "pixel_rays.hpp"

#include <random>

#include <gtest/gtest.h>

namespace mixed_palletizing::detection {
namespace {

TEST(PixelRays, recoversAPinholeFromPointsAtAnyDepth) {
  std::mt19937 rng(41);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 100; ++i) {
    const double focal = 300.0 + 3000.0 * uniform(rng);
    const Eigen::Vector2d center(2000.0 * uniform(rng), 1200.0 * uniform(rng));
    const Eigen::Vector2d at(2000.0 * uniform(rng), 1200.0 * uniform(rng));
    PixelRays rays;
    for (int k = 0; k < 300; ++k) {
      const Eigen::Vector2d pixel = at + 20.0 * Eigen::Vector2d(uniform(rng) - 0.5, uniform(rng) - 0.5);
      const double z = 0.5 + uniform(rng);
      const Eigen::Vector2d ray = (pixel - center) / focal;
      rays.add(pixel.x(), pixel.y(), Eigen::Vector3d(z * ray.x(), z * ray.y(), z).cast<float>());
    }
    ASSERT_TRUE(rays.fit());
    EXPECT_LT((rays.ray(at.x(), at.y()) - (at - center) / focal).norm(), 1e-6) << "seed 41, case " << i;
    const Eigen::Vector2d ray = (at - center) / focal;
    const auto pixel = rays.pixel(2.0 * Eigen::Vector3d(ray.x(), ray.y(), 1.0));
    ASSERT_TRUE(pixel);
    EXPECT_LT((*pixel - at).norm(), 0.02) << "seed 41, case " << i;
    EXPECT_FALSE(rays.pixel({0.1, 0.1, -1.0}));
  }
}

TEST(PixelRays, refusesTooFewPixelsAndPixelsOnALine) {
  PixelRays rays;
  EXPECT_FALSE(rays.fit());
  for (int k = 0; k < 10; ++k) rays.add(k, 2 * k, Eigen::Vector3f(0.1f * static_cast<float>(k), 0.2f, 1.0f));
  EXPECT_FALSE(rays.fit());
  PixelRays constant;
  for (int k = 0; k < 100; ++k) constant.add(k % 10, k / 10, Eigen::Vector3f(0.1f, 0.2f, 1.0f));
  EXPECT_FALSE(constant.fit());
}

}  // namespace
}  // namespace mixed_palletizing::detection
