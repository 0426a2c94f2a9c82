#include "rectangle_fit.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/pose.hpp>

#include "outline_match.hpp"

namespace mixed_palletizing::detection {
namespace {

using geometry::Rectangle;

constexpr double kPixel = 0.0005;

struct Case {
  Rectangle truth;
  EdgeRectangle start;
  std::vector<EdgeSample> samples;
};

/// Samples on all sides as a camera straight above sees them, a grid aligned with the world's axes.
Case randomCase(double noise_m, std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> normal(0.0, noise_m);
  Case c;
  c.truth.center = Eigen::Vector2d(uniform(rng) - 0.5, uniform(rng) - 0.5);
  c.truth.yaw_rad = 7.0 * uniform(rng);
  c.truth.size = Eigen::Vector2d(0.1 + 0.3 * uniform(rng), 0.1 + 0.3 * uniform(rng));
  const auto corners = c.truth.corners();
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d side = corners[(i + 1) % 4] - corners[i];
    const Eigen::Vector2d outward(side.y() / side.norm(), -side.x() / side.norm());
    const int count = static_cast<int>(side.norm() / kPixel);
    for (int k = 0; k < count; ++k) {
      EdgeSample sample;
      sample.place = corners[i] + (k + 0.5) / count * side + normal(rng) * outward;
      sample.outward = outward;
      sample.pixel_m = static_cast<float>(kPixel);
      sample.row = static_cast<int>(std::lround(1000.0 + sample.place.y() / kPixel));
      sample.col = static_cast<int>(std::lround(1000.0 + sample.place.x() / kPixel));
      for (const bool along_row : {true, false}) {
        sample.along_row = along_row;
        c.samples.push_back(sample);
      }
    }
  }
  c.start.rectangle = c.truth;
  c.start.rectangle.center += 0.001 * Eigen::Vector2d(uniform(rng) - 0.5, uniform(rng) - 0.5);
  c.start.rectangle.yaw_rad += 0.02 * (uniform(rng) - 0.5);
  c.start.rectangle.size += 0.002 * Eigen::Vector2d(uniform(rng) - 0.5, uniform(rng) - 0.5);
  return c;
}

RectangleFit fit(const Case& c) {
  FitBuffers buffers;
  return fitRectangle(c.samples, c.start, {kPixel, 0.0003, 0.0}, buffers);
}

double yawError(const RectangleFit& found, const Rectangle& truth) {
  return std::abs(geometry::foldQuarterTurn(found.rectangle.yaw_rad - truth.yaw_rad));
}

TEST(FitRectangle, averagesTheNoiseOfAllSamples) {
  std::mt19937 rng(81);
  for (int i = 0; i < 100; ++i) {
    const Case c = randomCase(0.0003, rng);
    const RectangleFit found = fit(c);
    ASSERT_EQ(found.foundSides(), 4) << "seed 81, case " << i;
    EXPECT_LT((found.rectangle.center - c.truth.center).norm(), 0.0001) << "seed 81, case " << i;
    EXPECT_LT((found.rectangle.size - c.truth.size).norm(), 0.00015) << "seed 81, case " << i;
    EXPECT_LT(yawError(found, c.truth), 0.001) << "seed 81, case " << i;
    EXPECT_GT(found.sides[0].stddev_m, 1e-6);
    EXPECT_LT(found.sides[0].stddev_m, 0.0002);
  }
}

TEST(FitRectangle, standsAThirdOfOutliersAndAHiddenSide) {
  std::mt19937 rng(82);
  std::uniform_real_distribution<double> uniform(-0.004, 0.004);
  for (int i = 0; i < 100; ++i) {
    Case c = randomCase(0.0002, rng);
    for (std::size_t k = 0; k < c.samples.size(); k += 3) {
      c.samples[k].place += Eigen::Vector2d(uniform(rng), uniform(rng));
    }
    // Side 2 is hidden: what is seen there belongs to what hides it.
    for (EdgeSample& sample : c.samples) {
      const bool on_side = c.truth.toLocal(sample.place).y() > 0.5 * c.truth.size.y() - 0.005;
      if (on_side) sample.beyond = Beyond::kOccluder;
    }
    const RectangleFit found = fit(c);
    EXPECT_EQ(found.foundSides(), 3) << "seed 82, case " << i;
    EXPECT_LT(std::abs(found.rectangle.size.x() - c.truth.size.x()), 0.0003) << "seed 82, case " << i;
    EXPECT_LT(yawError(found, c.truth), 0.003) << "seed 82, case " << i;
    EXPECT_FALSE(found.sides[2].found) << "seed 82, case " << i;
  }
}

TEST(FitRectangle, keepsTheStartWithoutSamples) {
  EdgeRectangle start;
  start.rectangle.size = Eigen::Vector2d(0.3, 0.2);
  FitBuffers buffers;
  const RectangleFit found = fitRectangle({}, start, {kPixel, 0.001, 0.0}, buffers);
  EXPECT_EQ(found.foundSides(), 0);
  EXPECT_EQ(found.rectangle.size, start.rectangle.size);
}

TEST(FitRectangle, movesRoundedSidesOntoTheirFaces) {
  std::mt19937 rng(84);
  for (int i = 0; i < 20; ++i) {
    Case c = randomCase(0.0002, rng);
    for (EdgeSample& sample : c.samples) {
      sample.has_face = true;
      sample.face = sample.place;
      sample.face_drop_m = 0.02f;
      sample.bent = true;
      sample.place -= 0.002 * sample.outward;
    }
    const RectangleFit found = fit(c);
    EXPECT_NEAR(found.rectangle.size.x(), c.truth.size.x(), 0.0003) << "seed 84, case " << i;
    EXPECT_NEAR(found.rectangle.size.y(), c.truth.size.y(), 0.0003) << "seed 84, case " << i;
  }
}

TEST(FitRectangle, completesRoundsOfWhichTheFaceIsNotSeen) {
  // Rounds of 6 mm: the surface ends 1 mm below the top, and 2.5 mm below it nothing more is seen.
  constexpr double kRadius = 0.006;
  constexpr double kEnd = 0.001;
  constexpr double kLast = 0.0025;
  const auto before = [](double drop) { return kRadius - std::sqrt(drop * (2.0 * kRadius - drop)); };
  std::mt19937 rng(85);
  for (int i = 0; i < 20; ++i) {
    Case c = randomCase(0.0002, rng);
    for (EdgeSample& sample : c.samples) {
      sample.has_face = true;
      sample.face = sample.place - before(kLast) * sample.outward;
      sample.face_drop_m = static_cast<float>(kLast);
      sample.place -= before(kEnd) * sample.outward;
      sample.bent = true;
      sample.drop_m = static_cast<float>(kEnd);
    }
    FitScale scale{kPixel, 0.0003, 0.0};
    scale.bend_m = kEnd;
    scale.camera << c.truth.center + Eigen::Vector2d(0.6, 0.4), 1.0;
    FitBuffers buffers;
    c.start.rectangle.size.array() -= 2.0 * before(kEnd);
    const RectangleFit found = fitRectangle(c.samples, c.start, scale, buffers);
    EXPECT_NEAR(found.rounding_m, kRadius, 0.0006) << "seed 85, case " << i;
    EXPECT_NEAR(found.rectangle.size.x(), c.truth.size.x(), 0.0006) << "seed 85, case " << i;
    EXPECT_NEAR(found.rectangle.size.y(), c.truth.size.y(), 0.0006) << "seed 85, case " << i;
  }
}

std::vector<OutlineSample> roundOutline() {
  std::vector<OutlineSample> disc;
  for (int k = 0; k < 1000; ++k) {
    OutlineSample sample;
    sample.measured = 0.1 * Eigen::Vector2d(std::cos(k * 0.001 * 2 * M_PI), std::sin(k * 0.001 * 2 * M_PI));
    disc.push_back(sample);
  }
  return disc;
}

TEST(MatchOutline, tellsRectanglesFromDiscs) {
  std::vector<OutlineSample> disc = roundOutline();
  Rectangle square;
  square.size = Eigen::Vector2d(0.2, 0.2);
  EXPECT_LT(matchOutline(disc, square, 0.002, 3.0).on_sides_ratio, 0.4);
  for (OutlineSample& sample : disc)
    sample.across = sample.measured.x() > 0.0 ? Across::kOccluder : Across::kBorder;
  const OutlineMatch hidden = matchOutline(disc, square, 0.002, 3.0);
  EXPECT_NEAR(hidden.occluded_ratio, 0.5, 0.01);
  EXPECT_NEAR(hidden.border_ratio, 0.5, 0.01);
}

}  // namespace
}  // namespace mixed_palletizing::detection
