#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/polygon.hpp>
#include <mixed_palletizing/geometry/pose.hpp>
#include <mixed_palletizing/geometry/rectangle.hpp>

namespace mixed_palletizing::geometry {
namespace {

Rectangle randomRectangle(std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Rectangle r;
  r.center = Eigen::Vector2d(uniform(rng) * 2.0 - 1.0, uniform(rng) * 2.0 - 1.0);
  r.yaw_rad = (uniform(rng) - 0.5) * 10.0;
  r.size = Eigen::Vector2d(0.05 + uniform(rng), 0.05 + uniform(rng));
  return r;
}

TEST(Rectangle, cornersRunCounterClockwiseAroundItsArea) {
  std::mt19937 rng(5);
  for (int i = 0; i < 300; ++i) {
    const Rectangle r = randomRectangle(rng);
    const auto corners = r.corners();
    EXPECT_NEAR(signedArea(Polygon(corners.begin(), corners.end())), r.area(), 1e-12) << "seed 5, case " << i;
    for (const Eigen::Vector2d& corner : corners) {
      EXPECT_TRUE(r.contains(corner, 1e-9));
      EXPECT_FALSE(r.contains(r.center + 1.01 * (corner - r.center)));
    }
  }
}

TEST(Rectangle, lengthFirstIsTheSameSetOfPoints) {
  std::mt19937 rng(6);
  for (int i = 0; i < 300; ++i) {
    const Rectangle r = randomRectangle(rng);
    const Rectangle turned = r.lengthFirst();
    EXPECT_GE(turned.size.x(), turned.size.y()) << "seed 6, case " << i;
    EXPECT_GE(turned.yaw_rad, -M_PI / 2);
    EXPECT_LT(turned.yaw_rad, M_PI / 2);
    for (const Eigen::Vector2d& corner : turned.corners()) EXPECT_TRUE(r.contains(corner, 1e-9));
    EXPECT_NEAR(turned.area(), r.area(), 1e-12);
  }
}

TEST(RectangleDistance, agreesWithDenseSampling) {
  std::mt19937 rng(8);
  for (int i = 0; i < 200; ++i) {
    const Rectangle a = randomRectangle(rng);
    const Rectangle b = randomRectangle(rng);
    double sampled = 1e9;
    for (int u = 0; u <= 60; ++u) {
      for (int v = 0; v <= 60; ++v) {
        const Eigen::Vector2d local((u / 60.0 - 0.5) * a.size.x(), (v / 60.0 - 0.5) * a.size.y());
        const Eigen::Vector2d p = a.center + local.x() * a.axisX() + local.y() * a.axisY();
        const Eigen::Vector2d outside =
            (b.toLocal(p).cwiseAbs() - 0.5 * b.size).cwiseMax(Eigen::Vector2d(0, 0));
        sampled = std::min(sampled, outside.norm());
      }
    }
    EXPECT_NEAR(distance(a, b), sampled, 0.02) << "seed 8, case " << i;
    EXPECT_NEAR(distance(a, b), distance(b, a), 1e-12);
    EXPECT_LE(distance(a, b), sampled + 1e-12);
  }
}

TEST(MinimumAreaRectangle, findsATurnedRectangleWithExtraCornersOnItsSides) {
  std::mt19937 rng(9);
  for (int i = 0; i < 200; ++i) {
    const Rectangle r = randomRectangle(rng).lengthFirst();
    const auto c = r.corners();
    const Polygon hull{c[0], 0.3 * c[0] + 0.7 * c[1], c[1], c[2], 0.5 * c[2] + 0.5 * c[3], c[3]};
    const Rectangle found = minimumAreaRectangle(hull);
    EXPECT_NEAR(found.area(), r.area(), 1e-9) << "seed 9, case " << i;
    EXPECT_LT((found.center - r.center).norm(), 1e-9);
    EXPECT_LT((found.size - r.size).norm(), 1e-9);
  }
}

TEST(MinimumAreaRectangle, refusesLines) {
  EXPECT_THROW(minimumAreaRectangle({{0, 0}, {1, 0}}), std::invalid_argument);
  EXPECT_EQ(signedArea({}), 0.0);
}

}  // namespace
}  // namespace mixed_palletizing::geometry
