#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/experiments/box_pairing.hpp>

#include "hand_made_boxes.hpp"

namespace mixed_palletizing::experiments {
namespace {

using test::detected;
using test::trueBox;

TEST(SharedArea, OfRectanglesThatAreKnown) {
  const geometry::Rectangle a{{0.0, 0.0}, 0.0, {2.0, 1.0}};
  EXPECT_NEAR(sharedArea(a, a), 2.0, 1e-12);
  EXPECT_NEAR(sharedArea(a, {{1.0, 0.5}, 0.0, {2.0, 1.0}}), 0.5, 1e-12);
  EXPECT_NEAR(sharedArea(a, {{0.0, 0.0}, M_PI / 2, {2.0, 1.0}}), 1.0, 1e-12);
  EXPECT_EQ(sharedArea(a, {{3.0, 0.0}, 0.3, {0.5, 0.5}}), 0.0);
  // A square turned by 45 degrees around the same centre shares a regular octagon.
  const geometry::Rectangle square{{0.0, 0.0}, 0.0, {1.0, 1.0}};
  EXPECT_NEAR(sharedArea(square, {{0.0, 0.0}, M_PI / 4, {1.0, 1.0}}), 2.0 * (std::sqrt(2.0) - 1.0), 1e-12);
}

TEST(SharedArea, AgreesWithCountedPoints) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 20; ++i) {
    const geometry::Rectangle a{{unit(random), unit(random)}, 3.0 * unit(random), {0.2 + unit(random), 0.3}};
    const geometry::Rectangle b{{unit(random), unit(random)}, 3.0 * unit(random), {0.5, 0.2 + unit(random)}};
    int inside = 0;
    constexpr int kPoints = 20000;
    for (int k = 0; k < kPoints; ++k) {
      const Eigen::Vector2d local((unit(random) - 0.5) * a.size.x(), (unit(random) - 0.5) * a.size.y());
      if (b.contains(a.center + a.axisX() * local.x() + a.axisY() * local.y())) ++inside;
    }
    EXPECT_NEAR(sharedArea(a, b), a.area() * inside / kPoints, 0.02 * a.area());
    EXPECT_NEAR(sharedArea(a, b), sharedArea(b, a), 1e-12);
  }
}

TEST(PairBoxes, TakesEveryBoxOnce) {
  const std::vector<TrueBox> truth = {trueBox(0.0, 0.0), trueBox(0.31, 0.0)};
  const std::vector<detection::DetectedBox> boxes = {detected(truth[1]), detected(truth[0]),
                                                     detected(truth[0])};
  const auto pairs = pairBoxes(truth, boxes);
  EXPECT_EQ(pairs[0], std::optional<std::size_t>(1));
  EXPECT_EQ(pairs[1], std::optional<std::size_t>(0));
}

TEST(PairBoxes, TwoBoxesReportedAsOneAreBothMissed) {
  const std::vector<TrueBox> truth = {trueBox(0.0, 0.0), trueBox(0.3, 0.0)};
  const TrueBox both = trueBox(0.15, 0.0, 0.0, {0.6, 0.2, 0.15});
  const auto pairs = pairBoxes(truth, {detected(both)});
  EXPECT_FALSE(pairs[0]);
  EXPECT_FALSE(pairs[1]);
}

TEST(PairBoxes, HeightTurnAndShiftDecide) {
  const std::vector<TrueBox> truth = {trueBox(0.0, 0.0)};
  const auto isFound = [&](const detection::DetectedBox& box) {
    return pairBoxes(truth, {box})[0].has_value();
  };
  detection::DetectedBox box = detected(truth[0]);
  EXPECT_TRUE(isFound(box));
  box.yaw_rad = M_PI;
  EXPECT_TRUE(isFound(box));
  box.yaw_rad = M_PI / 2;
  EXPECT_FALSE(isFound(box));
  box = detected(truth[0]);
  box.top_center.z() += 0.04;
  EXPECT_FALSE(isFound(box));
  box = detected(truth[0]);
  box.top_center.y() += 0.06;
  EXPECT_FALSE(isFound(box));
}

TEST(PairBoxes, PartOfATopIsFoundOnlyWhenTheRestIsHiddenAndItSaysSo) {
  std::vector<TrueBox> truth = {trueBox(0.0, 0.0)};
  const TrueBox half = trueBox(0.08, 0.0, 0.0, {0.14, 0.2, 0.15});
  detection::DetectedBox box = detected(half);
  EXPECT_FALSE(pairBoxes(truth, {box})[0]);
  box.flags = detection::kOccluded;
  EXPECT_FALSE(pairBoxes(truth, {box})[0]);
  truth[0].visible_ratio = 0.5;
  EXPECT_TRUE(pairBoxes(truth, {box})[0]);
  box.flags = detection::kTouching;
  EXPECT_FALSE(pairBoxes(truth, {box})[0]);
  truth[0].visible_ratio = 0.1;  // need not be found: a part of it is not invented
  EXPECT_TRUE(pairBoxes(truth, {box})[0]);
}

}  // namespace
}  // namespace mixed_palletizing::experiments
