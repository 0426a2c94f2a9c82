#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/planning/box_matching.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

using packing::ItemType;

const std::vector<ItemType> kTypes = {{"flat", {300, 200, 100}, {}, 0, 0},
                                      {"cube", {200, 200, 200}, {}, 0, 0},
                                      {"free", {500, 400, 250}, packing::Rotations::any(), 0, 0}};

MeasuredBox box(double length, double width, double height, double stddev = 1.0) {
  return {{length, width, height}, {stddev, stddev, stddev}};
}

TEST(MatchBox, findsTheTypeInEveryAllowedPose) {
  const std::vector<int> all{1, 1, 1};
  EXPECT_EQ(matchBox(box(304, 196, 103), kTypes, all, {}).type, 0);
  EXPECT_EQ(matchBox(box(196, 304, 103), kTypes, all, {}).type, 0);  // sides named the other way round
  EXPECT_EQ(matchBox(box(500, 250, 400), kTypes, all, {}).type, 2);
  EXPECT_EQ(matchBox(box(400, 250, 500), kTypes, all, {}).type, 2);
  const BoxMatch standing = matchBox(box(300, 100, 200), kTypes, all, {});
  EXPECT_EQ(standing.status, MatchStatus::kUnknown);  // "flat" may not stand on its side
  EXPECT_FALSE(standing.message.empty());
}

TEST(MatchBox, findsNoisyMeasurementsOfRandomTypes) {
  std::mt19937_64 rng(71);
  for (int run = 0; run < 500; ++run) {
    const packing::Order order = test::randomOrder(rng);
    const int type = test::draw(rng, 0, static_cast<int>(order.types.size()) - 1);
    const auto sizes = packing::orientations(order.types[static_cast<std::size_t>(type)]);
    const packing::Vec3 size = sizes[rng() % sizes.size()];
    const auto noise = [&rng] { return test::draw(rng, -10, 10); };
    const BoxMatch match = matchBox(
        box(std::max(size.x, size.y) + noise(), std::min(size.x, size.y) + noise(), size.z + noise()),
        order.types, order.counts, {});
    EXPECT_NE(match.status, MatchStatus::kUnknown) << "seed 71, run " << run << ": " << match.message;
    EXPECT_EQ(std::count(match.candidates.begin(), match.candidates.end(), type), 1)
        << "seed 71, run " << run;
  }
}

TEST(MatchBox, widensTheToleranceByTheUncertainty) {
  EXPECT_EQ(matchBox(box(325, 200, 100), kTypes, {1, 1, 1}, {}).status, MatchStatus::kUnknown);
  EXPECT_EQ(matchBox({{325, 200, 100}, {9, 1, 1}}, kTypes, {1, 1, 1}, {}).type, 0);
}

TEST(MatchBox, knowsAmbiguousFromAlike) {
  std::vector<ItemType> types = {{"a", {300, 200, 100}, packing::Rotations::yawOnly(), 0, 0},
                                 {"b", {306, 200, 100}, packing::Rotations::yawOnly(), 0, 0}};
  const BoxMatch match = matchBox(box(303, 200, 100), types, {1, 1}, {});
  EXPECT_EQ(match.status, MatchStatus::kAmbiguous);
  EXPECT_EQ(match.type, -1);
  EXPECT_EQ(match.candidates, (std::vector<int>{0, 1}));
  EXPECT_NE(match.message.find("'b'"), std::string::npos);
  EXPECT_EQ(matchBox(box(303, 200, 100), types, {0, 1}, {}).type, 1);
  types[1].size = {200, 300, 100};  // the same box, named the other way round
  EXPECT_EQ(matchBox(box(303, 200, 100), types, {1, 1}, {}).type, 0);
  types[1].weight_kg = 5.0;
  EXPECT_EQ(matchBox(box(303, 200, 100), types, {1, 1}, {}).status, MatchStatus::kAmbiguous);
}

TEST(MatchBox, refusesWhatIsNoMeasurement) {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 0.0, -300.0}) {
    EXPECT_EQ(matchBox(box(bad, 200, 100), kTypes, {1, 1, 1}, {}).status, MatchStatus::kUnknown);
  }
  for (const double bad : {nan, inf, -1.0}) {
    const BoxMatch match = matchBox(box(300, 200, 100, bad), kTypes, {1, 1, 1}, {});
    EXPECT_EQ(match.status, MatchStatus::kUnknown);
    EXPECT_NE(match.message.find("standard deviation"), std::string::npos);
  }
  EXPECT_NE(matchBox(box(300, 200, 100), kTypes, {0, 0, 0}, {}).message.find("no items"), std::string::npos);
  EXPECT_EQ(matchBox(box(1e300, 200, 100), kTypes, {1, 1, 1}, {}).status, MatchStatus::kUnknown);
  EXPECT_THROW(matchBox(box(300, 200, 100), kTypes, {1}, {}), std::invalid_argument);
  EXPECT_EQ(problems(MatchingOptions{nan, -1.0}).size(), 2U);
}

}  // namespace
}  // namespace mixed_palletizing::planning
