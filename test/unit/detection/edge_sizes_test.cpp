#include "edge_sizes.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {
namespace {

/// Sides of a rectangle, side 2 turned by `skew_rad` about its middle.
EdgeSides sidesOf(const geometry::Rectangle& rectangle, double skew_rad = 0.0) {
  const auto corners = rectangle.corners();
  EdgeSides sides;
  for (std::size_t i = 0; i < 4; ++i) sides[i] = Edge{corners[i], corners[(i + 1) % 4]};
  const Eigen::Vector2d middle = 0.5 * (sides[2]->from + sides[2]->to);
  const Eigen::Rotation2Dd turn(skew_rad);
  sides[2] = Edge{middle + turn * (sides[2]->from - middle), middle + turn * (sides[2]->to - middle)};
  return sides;
}

TEST(SizesFromEdges, AllFormulasAgreeOnARectangle) {
  const geometry::Rectangle truth{{0.7, -0.4}, 0.3, {0.3, 0.2}};
  const auto sizes = sizesFromEdges(sidesOf(truth));
  ASSERT_TRUE(sizes);
  for (const geometry::Rectangle& r : {sizes->by_offsets, sizes->along_yaw, sizes->smallest_sum}) {
    EXPECT_NEAR((r.center - truth.center).norm(), 0.0, 1e-9);
    EXPECT_NEAR(r.size.x(), 0.3, 1e-6);
    EXPECT_NEAR(r.size.y(), 0.2, 1e-6);
    EXPECT_NEAR(geometry::foldHalfTurn(r.yaw_rad - 0.3), 0.0, 1e-4);
  }
  EXPECT_NEAR(largestEdgeAngle(sidesOf(truth)), 0.0, 1e-12);
}

TEST(SizesFromEdges, TheDifferenceOfOffsetsDependsOnTheOriginForSkewEdges) {
  const double skew = 0.02;
  const geometry::Rectangle near{{0.0, 0.0}, 0.0, {0.3, 0.2}};
  geometry::Rectangle far = near;
  far.center = Eigen::Vector2d(1.0, 0.0);
  EXPECT_NEAR(largestEdgeAngle(sidesOf(far, skew)), skew, 1e-9);
  const auto at_origin = sizesFromEdges(sidesOf(near, skew));
  const auto away = sizesFromEdges(sidesOf(far, skew));
  ASSERT_TRUE(at_origin && away);
  EXPECT_NEAR(at_origin->by_offsets.size.y(), 0.2, 1e-4);
  EXPECT_GT(std::abs(away->by_offsets.size.y() - 0.2), 0.01);
  EXPECT_NEAR(away->along_yaw.size.y(), 0.2, 1e-3);
  EXPECT_NEAR(at_origin->along_yaw.size.y(), away->along_yaw.size.y(), 1e-9);
  EXPECT_LE(away->smallest_sum.size.sum(), away->along_yaw.size.sum() + 1e-9);
}

TEST(SizesFromEdges, NothingWithoutFourSides) {
  EdgeSides sides = sidesOf({{0.0, 0.0}, 0.0, {0.3, 0.2}});
  sides[3].reset();
  EXPECT_FALSE(sizesFromEdges(sides));
  sides[1].reset();
  sides[0] = std::nullopt;
  EXPECT_EQ(largestEdgeAngle(sides), 0.0);
}

}  // namespace
}  // namespace mixed_palletizing::detection
