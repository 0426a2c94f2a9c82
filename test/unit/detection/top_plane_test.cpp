#include "top_plane.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "height.hpp"

namespace mixed_palletizing::detection {
namespace {

/// Profile of a box: side faces spread over its height, the top at one height.
HeightProfile boxProfile(double height_m, double noise_m, int top, int sides, std::mt19937& rng) {
  std::normal_distribution<double> normal(0.0, noise_m);
  std::uniform_real_distribution<double> uniform(0.02, height_m);
  HeightProfile profile;
  const auto add = [&](double h) {
    const auto slice = static_cast<std::size_t>(std::max(0.0, h / profile.slice_m));
    if (slice >= profile.counts.size()) profile.counts.resize(slice + 1, 0);
    ++profile.counts[slice];
  };
  for (int k = 0; k < top; ++k) add(height_m + normal(rng));
  for (int k = 0; k < sides; ++k) add(uniform(rng) + normal(rng));
  return profile;
}

TEST(HeightProfile, countsCutSlicesByTheirShare) {
  HeightProfile profile;
  profile.counts = {10, 20, 30};
  EXPECT_DOUBLE_EQ(profile.between(0.0, 0.003), 60.0);
  EXPECT_NEAR(profile.between(0.0005, 0.0015), 15.0, 1e-9);
  EXPECT_DOUBLE_EQ(profile.between(-1.0, 1.0), 60.0);
  EXPECT_DOUBLE_EQ(profile.between(0.005, 0.006), 0.0);
  EXPECT_DOUBLE_EQ(HeightProfile().between(0.0, 1.0), 0.0);
}

TEST(TopLevel, andBandFollowTheTopOfAnyBoxAndNoise) {
  std::mt19937 rng(71);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 100; ++i) {
    const double height = 0.05 + 0.4 * uniform(rng);
    const double noise = 0.0001 + 0.004 * uniform(rng);
    const auto profile = boxProfile(height, noise, 20000, static_cast<int>(10000 * uniform(rng)), rng);
    const double window = std::max(0.004, 4.0 * noise);
    const TopLevel level = findTopLevel(profile, std::nullopt, 0.02, window);
    EXPECT_NEAR(level.height_m, height, 0.0005 + 0.5 * noise) << "seed 71, case " << i;
    const auto band = separateTop(profile, level, DetectionOptions());
    ASSERT_TRUE(band) << "seed 71, case " << i;
    EXPECT_LT(band->low_m, height - noise) << "seed 71, case " << i;
    EXPECT_GE(band->low_m, height - std::max(0.0105, 8.0 * noise) - 0.001) << "seed 71, case " << i;
    EXPECT_GT(band->high_m, height + 3.0 * noise) << "seed 71, case " << i;
  }
}

TEST(TopLevel, ofAFineSensorIsCutCloseBelowTheTop) {
  std::mt19937 rng(72);
  const auto profile = boxProfile(0.2, 0.0002, 100000, 20000, rng);
  const auto band =
      separateTop(profile, findTopLevel(profile, std::nullopt, 0.02, 0.004), DetectionOptions());
  ASSERT_TRUE(band);
  EXPECT_GT(band->low_m, 0.2 - 0.0035);
}

TEST(TopLevel, believesThePatchOnlyWhereItsLevelHoldsPoints) {
  std::mt19937 rng(73);
  const auto profile = boxProfile(0.2, 0.0003, 20000, 2000, rng);
  // A centroid that slid onto the side gives a patch below the top.
  EXPECT_NEAR(findTopLevel(profile, 0.12, 0.02, 0.004).height_m, 0.2, 0.001);
  EXPECT_NEAR(findTopLevel(profile, 0.2005, 0.02, 0.004).height_m, 0.2, 0.001);
}

TEST(TopBand, isMissingOnASlope) {
  std::mt19937 rng(74);
  const auto profile = boxProfile(0.3, 0.001, 0, 20000, rng);
  const TopLevel level = findTopLevel(profile, std::nullopt, 0.02, 0.004);
  const auto band = separateTop(profile, level, DetectionOptions());
  EXPECT_TRUE(!band || level.peak_density < 2.0 * level.side_density);
  EXPECT_FALSE(separateTop(HeightProfile(), TopLevel(), DetectionOptions()));
}

}  // namespace
}  // namespace mixed_palletizing::detection
