#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/placement_rule.hpp>

#include "definition_play.hpp"

namespace mixed_palletizing::packing {
namespace {

constexpr int kProofPlacements = 20000;  ///< scripts/torture.sh --only invariants makes a million

using test::draw;
using test::VoxelPallet;

TEST(PalletState, spacesAreThoseOfTheDefinition) {
  for (const int gap : {0, 1, 2}) {
    const unsigned seed = 11 + static_cast<unsigned>(gap);
    std::mt19937_64 rng(seed);
    const int wanted = gap == 0 ? kProofPlacements : kProofPlacements / 10;
    for (int placed = 0, game = 0; placed < wanted; ++game) {
      const PalletRules rules{{draw(rng, 3, 9), draw(rng, 3, 8), draw(rng, 2, 7)}, gap, 1.0};
      const test::Game played = test::playAgainstDefinition(PalletState(rules), rng, 40);
      ASSERT_EQ(played.fault, "") << "gap " << gap << ", game " << game << ", seed " << seed;
      placed += played.placed;
    }
  }
}

/// The same for empty maximal spaces: on small grids, as the definition is slow.
TEST(PalletState, emptySpacesAreThoseOfTheDefinition) {
  std::mt19937_64 rng(17);
  for (int placed = 0, game = 0; placed < kProofPlacements / 10; ++game) {
    Order order;
    order.rules = {{draw(rng, 3, 6), draw(rng, 3, 5), draw(rng, 2, 5)}, 0, rng() % 2 == 0 ? 1.0 : 0.5};
    const test::Game played = test::playAgainstDefinition(PalletState(order, SpaceKind::kEmpty), rng, 40);
    ASSERT_EQ(played.fault, "") << "seed 17, game " << game;
    placed += played.placed;
  }
}

/// Compares whyNot(), accepts() and the voxels for one size at every position.
void compareEverywhere(const PalletState& state, const Vec3& size) {
  const VoxelPallet voxels(state.rules(), state.placements());
  const Vec3 pallet = state.rules().size;
  for (int z = 0; z < pallet.z; ++z) {
    for (int y = -3; y < pallet.y + 2; ++y) {
      for (int x = -3; x < pallet.x + 2; ++x) {
        const Placement p{0, {x, y, z}, size};
        const std::string reason = state.whyNot(p);
        ASSERT_EQ(reason.empty(), voxels.accepts(p)) << x << " " << y << " " << z << ": " << reason;
        ASSERT_EQ(reason.empty(), state.accepts(p)) << x << " " << y << " " << z << ": " << reason;
      }
    }
  }
}

TEST(PalletState, tellsTheChangedLevelsBeforehand) {
  std::mt19937_64 rng(23);
  for (int round = 0; round < 400; ++round) {
    PalletState state = test::randomPallet({{12, 10, 9}, round % 4 == 3 ? 1 : 0, 1.0}, rng, 12, 5);
    if (state.spaces().empty()) continue;
    const Placement placement = test::randomPlacement(state, rng, 5);
    if (!state.accepts(placement)) continue;
    ChangedLevels changed;
    const bool told = state.levelsAfter(placement, changed);
    EXPECT_EQ(told, state.rules().gap == 0) << "seed 23, round " << round;
    if (!told) continue;
    const int base = placement.origin.z;
    const int top = base + placement.size.z;
    std::vector<Space> expected = changed.base;
    expected.insert(expected.end(), changed.top.begin(), changed.top.end());
    for (const Space& space : state.spaces()) {
      if (space.min.z != base && space.min.z != top) expected.push_back(space);
    }
    state.place(placement);
    EXPECT_TRUE(
        std::is_permutation(expected.begin(), expected.end(), state.spaces().begin(), state.spaces().end()))
        << "seed 23, round " << round;
  }
}

TEST(PalletState, whyNotAndSpacesAgreeWithCountedVoxels) {
  std::mt19937_64 rng(21);
  for (int round = 0; round < 4000; ++round) {
    const double ratios[] = {1.0, 1.0, 0.9, 0.75, 0.5, 0.3};
    PalletRules rules{
        {draw(rng, 3, 8), draw(rng, 3, 8), draw(rng, 2, 6)}, draw(rng, 0, 2), ratios[rng() % 6]};
    if (rules.min_support_ratio < 1.0) rules.overhang = draw(rng, 0, 2);
    const PalletState state = test::randomPallet(rules, rng, draw(rng, 0, 12), 4);
    compareEverywhere(state, {draw(rng, 1, 4), draw(rng, 1, 4), draw(rng, 1, 3)});
    ASSERT_FALSE(HasFailure()) << "seed 21, round " << round;
  }
}

/// With partial support every valid box lies in a space, and undo restores what was.
TEST(PalletState, spacesOfPartialSupportHoldEveryValidBox) {
  std::mt19937_64 rng(31);
  for (int round = 0; round < 3000; ++round) {
    const PalletRules rules{
        {draw(rng, 3, 8), draw(rng, 3, 8), draw(rng, 2, 6)}, draw(rng, 0, 1), 0.6, draw(rng, 0, 2)};
    PalletState state = test::randomPallet(rules, rng, draw(rng, 1, 10), 4);
    PalletState again(rules);
    for (const Placement& p : state.placements()) again.place(p);
    const std::vector<Space> before = state.spaces();
    EXPECT_TRUE(again.spaces() == before) << "a rebuilt pallet has the same spaces";
    for (int tries = 0; tries < 30; ++tries) {
      const Vec3 size{draw(rng, 1, 4), draw(rng, 1, 4), draw(rng, 1, 3)};
      const Placement p{
          0, {draw(rng, -2, rules.size.x), draw(rng, -2, rules.size.y), draw(rng, 0, rules.size.z)}, size};
      if (!state.accepts(p)) continue;
      const bool held = std::any_of(before.begin(), before.end(), [&](const Space& s) {
        return s.min.z == p.origin.z && s.min.x <= p.origin.x && s.min.y <= p.origin.y &&
               p.origin.x + size.x <= s.max.x && p.origin.y + size.y <= s.max.y;
      });
      EXPECT_TRUE(held);
      state.place(p);
      EXPECT_TRUE(state.undo());
      EXPECT_TRUE(state.spaces() == before);
    }
    ASSERT_FALSE(HasFailure()) << "seed 31, round " << round;
  }
}

TEST(PalletState, aGapIsKeptBetweenBoxesButNotToTheBorder) {
  PalletState state(PalletRules{{1000, 600, 500}, 20, 1.0});
  state.place({0, {0, 0, 0}, {300, 200, 100}});
  EXPECT_NE(state.whyNot({0, {310, 0, 0}, {300, 200, 100}}).find("gap of 20 mm"), std::string::npos);
  EXPECT_EQ(state.whyNot({0, {320, 0, 0}, {300, 200, 100}}), "");
  EXPECT_EQ(state.whyNot({0, {310, 220, 0}, {300, 200, 100}}), "") << "clear in y is enough";
  EXPECT_EQ(state.whyNot({0, {0, 0, 100}, {300, 200, 100}}), "") << "no gap on top";
  state.place({0, {320, 0, 0}, {300, 200, 100}});
  EXPECT_NE(state.whyNot({0, {0, 0, 100}, {620, 200, 100}}).find("supported share"), std::string::npos);
  PalletState bridging(PalletRules{{1000, 600, 500}, 20, 0.9});
  bridging.place({0, {0, 0, 0}, {300, 200, 100}});
  bridging.place({0, {320, 0, 0}, {300, 200, 100}});
  EXPECT_EQ(bridging.whyNot({0, {0, 0, 100}, {620, 200, 100}}), "") << "600 of 620 mm are supported";
}

TEST(PalletState, partialSupportNeedsTheCentreOverTheSupport) {
  PalletState state(PalletRules{{1000, 600, 500}, 0, 0.4});
  state.place({0, {0, 0, 0}, {300, 300, 100}});
  EXPECT_EQ(state.whyNot({0, {0, 0, 100}, {590, 300, 100}}), "");
  EXPECT_NE(state.whyNot({0, {0, 0, 100}, {600, 300, 100}}).find("centre"), std::string::npos);
  state.place({0, {700, 0, 0}, {300, 300, 100}});
  EXPECT_EQ(state.whyNot({0, {0, 0, 100}, {1000, 300, 100}}), "") << "a bridge rests on both ends";
  state.place({0, {0, 0, 100}, {1000, 300, 100}});
  EXPECT_NE(state.whyNot({0, {400, 0, 0}, {100, 100, 100}}).find("lowered"), std::string::npos);
}

TEST(PalletState, tellsTheLoadByTheAreasOfContact) {
  Order order;
  order.rules = {{1000, 600, 500}, 0, 0.5, 50, 40.0};
  order.types = {{"A", {200, 200, 100}, {}, 10.0, 6.0},
                 {"B", {400, 200, 100}, {}, 8.0},
                 {"C", {100, 100, 100}, {}, 5.0}};
  PalletState state(order);
  state.place({0, {0, 0, 0}, {200, 200, 100}});
  state.place({0, {200, 0, 0}, {200, 200, 100}});
  state.place({1, {100, 0, 100}, {400, 200, 100}});
  EXPECT_DOUBLE_EQ(state.loads()[0], 8.0 / 3.0) << "100 of 300 mm rest on it";
  EXPECT_DOUBLE_EQ(state.loads()[1], 16.0 / 3.0);
  EXPECT_NE(state.whyNot({2, {300, 0, 200}, {100, 100, 100}}).find("would carry"), std::string::npos);
  EXPECT_FALSE(state.accepts({2, {300, 0, 200}, {100, 100, 100}})) << "handed down to the right one";
  EXPECT_TRUE(state.undo());
  EXPECT_DOUBLE_EQ(state.loads()[1], 0.0);
  state.place({2, {0, 0, 100}, {100, 100, 100}});
  EXPECT_DOUBLE_EQ(state.loads()[0], 5.0);
  EXPECT_EQ(state.whyNot({2, {-40, 300, 0}, {100, 100, 100}}), "") << "40 mm over the side";
  EXPECT_NE(state.whyNot({2, {-60, 300, 0}, {100, 100, 100}}).find("by more than 50 mm"), std::string::npos);
  state.place({1, {400, 300, 0}, {400, 200, 100}});
  EXPECT_NE(state.whyNot({0, {0, 300, 0}, {200, 200, 100}}).find("43.0"), std::string::npos)
      << "too heavy in all";
  EXPECT_FALSE(state.carriesWeightOf(0));
  EXPECT_TRUE(cornerPlacements(state, order.types[0], 0).empty());
}

TEST(PalletState, saysWhyABoxIsRefused) {
  PalletState state(PalletRules{{100, 80, 60}});
  state.place({0, {0, 0, 0}, {50, 40, 30}});
  const auto reason = [&](const Vec3& origin, const Vec3& size) { return state.whyNot({1, origin, size}); };
  EXPECT_NE(reason({60, 50, 0}, {50, 10, 10}).find("sticks out"), std::string::npos);
  EXPECT_NE(reason({-1, 50, 0}, {50, 10, 10}).find("sticks out"), std::string::npos);
  EXPECT_NE(reason({40, 30, 0}, {50, 40, 30}).find("overlaps box 0"), std::string::npos);
  EXPECT_NE(reason({0, 0, 30}, {50, 50, 10}).find("supported share"), std::string::npos);
  EXPECT_NE(reason({0, 0, 31}, {10, 10, 10}).find("supported share"), std::string::npos);
  EXPECT_NE(reason({60, 50, 0}, {0, 10, 10}).find("not positive"), std::string::npos);
  EXPECT_NE(state.whyNot({-1, {60, 50, 0}, {10, 10, 10}}).find("negative"), std::string::npos);
  const int huge = std::numeric_limits<int>::max();
  EXPECT_NE(reason({huge, 50, 0}, {huge, 10, 10}).find("sticks out"), std::string::npos);
  EXPECT_FALSE(state.accepts({1, {huge, huge, huge}, {huge, huge, huge}}));
  EXPECT_THROW(state.place({0, {40, 30, 0}, {50, 40, 30}}), std::invalid_argument);
  EXPECT_EQ(state.placements().size(), 1U) << "a refused box changes nothing";
}

TEST(PalletState, refusesRulesThatMakeNoPallet) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(PalletState(PalletRules{{0, 800, 600}}), std::invalid_argument);
  EXPECT_THROW(PalletState(PalletRules{{1200, -1, 600}}), std::invalid_argument);
  EXPECT_THROW(PalletState(PalletRules{{1200, 800, kMaxPalletLength + 1}}), std::invalid_argument);
  EXPECT_THROW(PalletState(PalletRules{{1200, 800, 600}, -1, 1.0}), std::invalid_argument);
  for (const double ratio : {0.0, -0.5, 1.01, nan}) {
    EXPECT_THROW(PalletState(PalletRules{{1200, 800, 600}, 0, ratio}), std::invalid_argument) << ratio;
  }
}

TEST(PalletState, countsVolumeAndCopiesAreIndependent) {
  PalletState state(PalletRules{{1200, 800, 600}});
  EXPECT_FALSE(state.undo());
  state.place({0, {0, 0, 0}, {1200, 800, 300}});
  PalletState copy = state;
  copy.place({0, {0, 0, 300}, {600, 800, 300}});
  EXPECT_EQ(copy.packedVolume(), 432000000);
  EXPECT_DOUBLE_EQ(copy.utilization(), 0.75);
  EXPECT_DOUBLE_EQ(state.utilization(), 0.5);
  EXPECT_TRUE(copy.undo());
  EXPECT_TRUE(copy.spaces() == state.spaces());
  state.place({0, {0, 0, 300}, {1200, 800, 300}});
  EXPECT_TRUE(state.spaces().empty()) << "a full pallet has no space";
}

}  // namespace
}  // namespace mixed_palletizing::packing
