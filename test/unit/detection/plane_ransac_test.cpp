#include "plane_ransac.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/organized_cloud.hpp>

namespace mixed_palletizing::detection {
namespace {

/// A grid of rays; a share of them meets the plane, the rest ends at random depths or has no data.
geometry::OrganizedCloud planeCloud(const geometry::Plane& plane, double share, double noise_m,
                                    std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> normal(0.0, noise_m);
  geometry::OrganizedCloud cloud;
  cloud.width = 160;
  cloud.height = 120;
  for (int row = 0; row < cloud.height; ++row) {
    for (int col = 0; col < cloud.width; ++col) {
      geometry::ColoredPoint point;
      const Eigen::Vector3d ray((col - 80) / 250.0, (row - 60) / 250.0, 1.0);
      const double at = -plane.offset / plane.normal.dot(ray);
      const double z = uniform(rng) < share ? at + normal(rng) : 0.4 + 1.2 * uniform(rng);
      if (uniform(rng) < 0.9) {
        point.x = static_cast<float>(z * ray.x());
        point.y = static_cast<float>(z * ray.y());
        point.z = static_cast<float>(z);
      }
      cloud.points.push_back(point);
    }
  }
  return cloud;
}

geometry::Plane randomPlane(std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform(-0.6, 0.6);
  geometry::Plane plane;
  plane.normal = Eigen::Vector3d(uniform(rng), uniform(rng), -1.0).normalized();
  plane.offset = 1.0 + 0.4 * uniform(rng);
  return plane;
}

TEST(FindPlanes, findsItAmongOutliersWithFineAndCoarseNoise) {
  std::mt19937 rng(51);
  for (int i = 0; i < 30; ++i) {
    const geometry::Plane plane = randomPlane(rng);
    const double noise = i % 2 == 0 ? 0.0003 : 0.006;
    const auto cloud = planeCloud(plane, 0.3 + 0.02 * i, noise, rng);
    const PlanesResult result = findPlanes(cloud.view(), PlaneOptions());
    ASSERT_EQ(result.fits.size(), 1u) << result.message << ", seed 51, case " << i;
    EXPECT_LT(std::acos(std::min(1.0, result.fits[0].plane.normal.dot(plane.normal))),
              0.1 * noise / 0.0003 * 0.02)
        << "seed 51, case " << i;
    EXPECT_NEAR(result.fits[0].plane.offset, plane.offset, 0.5 * noise + 1e-4) << "seed 51, case " << i;
    EXPECT_GT(result.fits[0].plane.offset, 0.0) << "the normal points to the camera";
    EXPECT_LT(result.fits[0].rms_m, 2.0 * noise + 0.001);
  }
}

TEST(FindPlanes, isTheSameForTheSameSeed) {
  std::mt19937 rng(52);
  const auto cloud = planeCloud(randomPlane(rng), 0.5, 0.001, rng);
  const auto a = findPlanes(cloud.view(), PlaneOptions());
  const auto b = findPlanes(cloud.view(), PlaneOptions());
  ASSERT_EQ(a.fits.size(), 1u);
  ASSERT_EQ(b.fits.size(), 1u);
  EXPECT_EQ(a.fits[0].plane.offset, b.fits[0].plane.offset);
  EXPECT_EQ(a.fits[0].inliers, b.fits[0].inliers);
}

TEST(FindPlanes, saysWhatItSawInstead) {
  geometry::OrganizedCloud empty;
  empty.width = empty.height = 10;
  empty.points.resize(100);
  const auto none = findPlanes(empty.view(), PlaneOptions());
  EXPECT_TRUE(none.fits.empty());
  EXPECT_NE(none.message.find("10 x 10 has 0 points"), std::string::npos) << none.message;

  std::mt19937 rng(53);
  PlaneOptions strict;
  strict.min_inlier_ratio = 0.9;
  const auto small = findPlanes(planeCloud(randomPlane(rng), 0.4, 0.001, rng).view(), strict);
  EXPECT_TRUE(small.fits.empty());
  EXPECT_NE(small.message.find("less than 90 %"), std::string::npos) << small.message;
}

TEST(FindPlanes, survivesPointsOnALineAndOnASpot) {
  geometry::OrganizedCloud cloud;
  cloud.width = 50;
  cloud.height = 2;
  for (int k = 0; k < 100; ++k) cloud.points.push_back({0.01f * static_cast<float>(k), 0.0f, 1.0f, 0});
  EXPECT_TRUE(findPlanes(cloud.view(), PlaneOptions()).fits.empty());
  for (auto& point : cloud.points) point = {0.1f, 0.1f, 1.0f, 0};
  EXPECT_TRUE(findPlanes(cloud.view(), PlaneOptions()).fits.empty());
}

}  // namespace
}  // namespace mixed_palletizing::detection
