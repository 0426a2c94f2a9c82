#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/units.hpp>

namespace mixed_palletizing::adapters {
namespace {

TEST(Units, wholeMillimetersSurviveFloatingPoint) {
  for (int mm = -20000; mm <= 20000; ++mm) {
    const double m = mm / 1000.0;
    ASSERT_EQ(millimetersUp(m), mm);
    ASSERT_EQ(millimetersDown(m), mm);
    ASSERT_EQ(millimetersNearest(m), mm);
    ASSERT_EQ(millimetersUp(0.1 * mm * 0.01), mm);
    ASSERT_EQ(millimetersNearest(toMeters(mm)), mm);
  }
}

TEST(Units, roundsToTheStatedSide) {
  const unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> length(-5.0, 5.0);
  for (int i = 0; i < 100000; ++i) {
    const double m = length(random);
    const double mm = m * kMillimetersPerMeter;
    ASSERT_GE(millimetersUp(m), mm - kUnitNoiseMm);
    ASSERT_LT(millimetersUp(m), mm + 1.0);
    ASSERT_LE(millimetersDown(m), mm + kUnitNoiseMm);
    ASSERT_GT(millimetersDown(m), mm - 1.0);
    ASSERT_LE(std::abs(millimetersNearest(m) - mm), 0.5);
  }
}

TEST(Units, refusesWhatIsNoLength) {
  for (const double m : {std::nan(""), std::numeric_limits<double>::infinity(),
                         -std::numeric_limits<double>::infinity(), 1e308, 1000.001, -1001.0}) {
    EXPECT_FALSE(isLength(m));
    EXPECT_THROW(millimetersUp(m), std::invalid_argument);
    EXPECT_THROW(millimetersDown(m), std::invalid_argument);
    EXPECT_THROW(millimetersNearest(m), std::invalid_argument);
  }
  EXPECT_TRUE(isLength(0.0));
  EXPECT_TRUE(isLength(-1000.0));
}

}  // namespace
}  // namespace mixed_palletizing::adapters
