#include <cmath>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/plane.hpp>

namespace mixed_palletizing::geometry {
namespace {

TEST(PlaneAccumulator, findsRandomPlanesFarFromTheOrigin) {
  std::mt19937 rng(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d n = Eigen::Vector3d(normal(rng), normal(rng), normal(rng)).normalized();
    const Eigen::Vector3d origin(uniform(rng), uniform(rng), 100.0 + uniform(rng));
    const Eigen::Vector3d u = n.unitOrthogonal();
    const Eigen::Vector3d v = n.cross(u);
    const double sigma = 0.001;
    PlaneAccumulator accumulator;
    for (int k = 0; k < 2000; ++k) {
      accumulator.add(origin + uniform(rng) * u + uniform(rng) * v + sigma * normal(rng) * n);
    }
    const PlaneAccumulator::Fit fit = accumulator.fit();
    EXPECT_GT(std::abs(fit.plane.normal.dot(n)), std::cos(0.001)) << "seed 7, case " << i;
    EXPECT_LT(std::abs(fit.plane.signedDistance(origin)), 3e-4);
    EXPECT_NEAR(fit.rms_m, sigma, 1e-4);
  }
}

TEST(PlaneAccumulator, refusesTooFewAndCollinearPoints) {
  PlaneAccumulator accumulator;
  accumulator.add({0.0, 0.0, 1.0});
  accumulator.add({1.0, 0.0, 1.0});
  EXPECT_THROW(accumulator.fit(), std::invalid_argument);
  accumulator.add({2.0, 0.0, 1.0});
  EXPECT_THROW(accumulator.fit(), std::invalid_argument);
  accumulator.add({2.0, 1.0, 1.0});
  EXPECT_NO_THROW(accumulator.fit());
}

TEST(Plane, facesTheGivenPoint) {
  const Plane plane{-Eigen::Vector3d::UnitZ(), 1.0};  // z = 1
  const Plane up = plane.facing({0.0, 0.0, 5.0});
  EXPECT_GT(up.signedDistance({0.0, 0.0, 5.0}), 0.0);
  EXPECT_NEAR(up.signedDistance({3.0, 2.0, 1.0}), 0.0, 1e-15);
}

}  // namespace
}  // namespace mixed_palletizing::geometry
