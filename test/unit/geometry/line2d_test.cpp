#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/line2d.hpp>

namespace mixed_palletizing::geometry {
namespace {

TEST(Line2d, holdsItsPointsAndMeetsOthersWhereBothVanish) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  const auto point = [&] { return Eigen::Vector2d(uniform(rng), uniform(rng)); };
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d a = point();
    const Eigen::Vector2d b = point();
    const Line2d line = Line2d::through(a, b);
    EXPECT_NEAR(line.signedDistance(a), 0.0, 1e-12) << "seed 3, case " << i;
    EXPECT_NEAR(line.signedDistance(b), 0.0, 1e-12);
    EXPECT_GT(line.direction().dot(b - a), 0.0);
    EXPECT_NEAR(line.signedDistance(a + 0.7 * line.normal), 0.7, 1e-12);
    const Line2d other = Line2d::through(point(), point());
    const auto common = intersection(line, other);
    ASSERT_TRUE(common);
    EXPECT_NEAR(line.signedDistance(*common), 0.0, 1e-9 * (1.0 + common->norm()) * 1e3);
    EXPECT_NEAR(other.signedDistance(*common), 0.0, 1e-9 * (1.0 + common->norm()) * 1e3);
  }
}

TEST(Line2d, refusesCoincidingPointsAndParallelLinesDoNotMeet) {
  EXPECT_THROW(Line2d::through({1.0, 2.0}, {1.0, 2.0}), std::invalid_argument);
  EXPECT_FALSE(intersection(Line2d::through({0, 0}, {1, 1}), Line2d::through({0, 1}, {1, 2})));
}

TEST(MeanLine, liesHalfWayInEitherSense) {
  const Line2d low = Line2d::through({0, 0}, {1, 0});
  for (const bool reversed : {false, true}) {
    const Line2d high = reversed ? Line2d::through({1, 2.1}, {0, 1.9}) : Line2d::through({0, 1.9}, {1, 2.1});
    const Line2d mean = meanLine(low, high);
    for (const double x : {-3.0, 0.0, 4.0}) {
      // A point of the bisector is as far from the one as from the other line.
      const Eigen::Vector2d p = Eigen::Vector2d(x, 0.0) - mean.signedDistance({x, 0.0}) * mean.normal;
      EXPECT_NEAR(std::abs(low.signedDistance(p)), std::abs(high.signedDistance(p)), 1e-12);
    }
    EXPECT_GT(mean.normal.dot(low.normal), 0.9);
  }
}

}  // namespace
}  // namespace mixed_palletizing::geometry
