#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::geometry {
namespace {

TEST(AlignVectors, turnsAnyUnitVectorOntoAnyOther) {
  std::mt19937 rng(11);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d a = Eigen::Vector3d(normal(rng), normal(rng), normal(rng)).normalized();
    const Eigen::Vector3d b = Eigen::Vector3d(normal(rng), normal(rng), normal(rng)).normalized();
    const Eigen::Matrix3d r = alignVectors(a, b);
    EXPECT_LT((r * a - b).norm(), 1e-12) << "seed 11, case " << i;
    EXPECT_NEAR(r.determinant(), 1.0, 1e-12);
    EXPECT_LT((r.transpose() * r - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    // Eq. 3.6: the axis is perpendicular to both, so it stays where it is.
    EXPECT_LT((r * a.cross(b) - a.cross(b)).norm(), 1e-12);
  }
}

TEST(AlignVectors, staysFiniteForEqualAndOppositeVectors) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  EXPECT_LT((alignVectors(z, z) - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_LT((alignVectors(z, -z) * z + z).norm(), 1e-12);
}

TEST(FoldHalfTurn, isHalfOpenAndKeepsTheDirection) {
  EXPECT_DOUBLE_EQ(foldHalfTurn(-M_PI / 2), -M_PI / 2);
  EXPECT_DOUBLE_EQ(foldHalfTurn(M_PI / 2), -M_PI / 2);
  for (double angle = -20.0; angle < 20.0; angle += 0.0137) {
    const double folded = foldHalfTurn(angle);
    EXPECT_GE(folded, -M_PI / 2);
    EXPECT_LT(folded, M_PI / 2);
    EXPECT_NEAR(std::sin(angle - folded), 0.0, 1e-9);
  }
}

TEST(FoldQuarterTurn, isHalfOpenAndRepeatsEveryQuarter) {
  for (double angle = -20.0; angle < 20.0; angle += 0.0137) {
    const double folded = foldQuarterTurn(angle);
    EXPECT_GE(folded, -M_PI / 4);
    EXPECT_LT(folded, M_PI / 4);
    EXPECT_NEAR(std::sin(2.0 * (angle - folded)), 0.0, 1e-9);
  }
}

TEST(PoseFromYaw, roundTrips) {
  for (double yaw = -3.1; yaw < 3.1; yaw += 0.1) {
    EXPECT_NEAR(yawOf(poseFromYaw({1.0, 2.0, 3.0}, yaw)), yaw, 1e-12);
  }
}

}  // namespace
}  // namespace mixed_palletizing::geometry
