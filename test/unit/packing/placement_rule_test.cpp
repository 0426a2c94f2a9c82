#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <tuple>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/placement_rule.hpp>

#include "brute_force.hpp"
#include "random_play.hpp"

namespace mixed_palletizing::packing {
namespace {

using test::draw;
using test::VoxelPallet;

using Rank = std::tuple<long, int, int, int, std::size_t>;

Rank rankOf(const Placement& p, PlacementRule rule, const std::vector<Vec3>& sizes) {
  const Vec3& o = p.origin;
  const long distance = rule == PlacementRule::kDistance ? o.x * o.x + o.y * o.y + o.z * o.z : 0;
  const auto at = std::find(sizes.begin(), sizes.end(), p.size) - sizes.begin();
  return {distance, o.z, o.y, o.x, static_cast<std::size_t>(at)};
}

/// The best of all positions and orientations by counted voxels.
std::optional<Rank> bestByVoxels(const PalletState& state, const ItemType& type, PlacementRule rule) {
  const VoxelPallet voxels(state.rules(), state.placements());
  const std::vector<Vec3> sizes = orientations(type);
  std::optional<Rank> best;
  for (const Vec3& size : sizes) {
    for (int z = 0; z < state.rules().size.z; ++z) {
      for (int y = 0; y < state.rules().size.y; ++y) {
        for (int x = 0; x < state.rules().size.x; ++x) {
          const Placement p{0, {x, y, z}, size};
          if (voxels.accepts(p) && (!best || rankOf(p, rule, sizes) < *best)) best = rankOf(p, rule, sizes);
        }
      }
    }
  }
  return best;
}

ItemType randomType(std::mt19937_64& rng) {
  const Rotations kinds[] = {Rotations::none(), Rotations::yawOnly(), Rotations::any()};
  return {"A", {draw(rng, 1, 4), draw(rng, 1, 4), draw(rng, 1, 3)}, kinds[rng() % 3]};
}

TEST(FindPlacement, isTheBestOfAllValidPlaces) {
  std::mt19937_64 rng(3);
  for (int round = 0; round < 6000; ++round) {
    const PalletRules rules{{draw(rng, 3, 8), draw(rng, 3, 8), draw(rng, 2, 6)}, draw(rng, 0, 4) / 3, 1.0};
    const PalletState state = test::randomPallet(rules, rng, draw(rng, 0, 15), 4);
    const ItemType type = randomType(rng);
    for (const PlacementRule rule : {PlacementRule::kDblf, PlacementRule::kDistance}) {
      const auto found = findPlacement(state, type, 0, rule);
      const auto best = bestByVoxels(state, type, rule);
      ASSERT_EQ(found.has_value(), best.has_value()) << "seed 3, round " << round;
      if (found) {
        ASSERT_EQ(rankOf(*found, rule, orientations(type)), *best) << "seed 3, round " << round;
      }
    }
  }
}

TEST(FindPlacement, obeysThePartialSupportRules) {
  std::mt19937_64 rng(4);
  int placed = 0;
  for (int round = 0; round < 2000; ++round) {
    PalletState state(PalletRules{{draw(rng, 4, 9), draw(rng, 4, 9), draw(rng, 3, 8)}, draw(rng, 0, 1), 0.7});
    for (int i = 0; i < 15; ++i) {
      const PlacementRule rule = rng() % 2 == 0 ? PlacementRule::kDblf : PlacementRule::kDistance;
      const auto found = findPlacement(state, randomType(rng), 0, rule);
      if (!found) continue;
      ASSERT_TRUE(VoxelPallet(state.rules(), state.placements()).accepts(*found))
          << "seed 4, round " << round;
      state.place(*found);
      ++placed;
    }
  }
  EXPECT_GT(placed, 10000);
}

TEST(FindPlacement, bridgesAGapWhenTheRatioAllowsIt) {
  PalletState state(PalletRules{{620, 200, 500}, 20, 0.9});
  state.place({0, {0, 0, 0}, {300, 200, 100}});
  state.place({0, {320, 0, 0}, {300, 200, 100}});
  const auto found = findPlacement(state, {"long", {600, 200, 100}, {}}, 1, PlacementRule::kDblf);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->origin, (Vec3{0, 0, 100}));
}

TEST(FindPlacement, refusesNonsense) {
  const PalletState state(PalletRules{{100, 100, 100}});
  EXPECT_THROW(findPlacement(state, {"A", {10, 10, 10}, {}}, -1, PlacementRule::kDblf),
               std::invalid_argument);
  EXPECT_THROW(findPlacement(state, {"A", {10, 0, 10}, {}}, 0, PlacementRule::kDblf), std::invalid_argument);
  EXPECT_THROW(cornerPlacements(state, {"A", {10, -1, 10}, {}}, 0), std::invalid_argument);
  EXPECT_FALSE(findPlacement(state, {"A", {101, 10, 10}, {}}, 0, PlacementRule::kDistance));
  EXPECT_FALSE(
      findPlacement(state, {"A", {10, 10, 10}, {true, {false, false, false}}}, 0, PlacementRule::kDblf));
}

TEST(CornerPlacements, areAllValidDistinctAndComplete) {
  std::mt19937_64 rng(6);
  for (int round = 0; round < 3000; ++round) {
    const double ratio = rng() % 2 == 0 ? 1.0 : 0.7;
    const PalletRules rules{{draw(rng, 3, 8), draw(rng, 3, 8), draw(rng, 2, 6)}, draw(rng, 0, 4) / 3, ratio};
    const PalletState state = test::randomPallet(rules, rng, draw(rng, 0, 15), 4);
    const ItemType type = randomType(rng);
    const VoxelPallet voxels(rules, state.placements());
    std::set<std::tuple<int, int, int, int, int, int>> seen;
    for (const Placement& p : cornerPlacements(state, type, 0)) {
      ASSERT_TRUE(voxels.accepts(p)) << "seed 6, round " << round;
      ASSERT_TRUE(seen.emplace(p.origin.x, p.origin.y, p.origin.z, p.size.x, p.size.y, p.size.z).second);
    }
    for (const Space& space : state.spaces()) {
      for (const Vec3& size : orientations(type)) {
        const Placement p{0, space.min, size};
        const Vec3 room = space.size();
        if (size.x > room.x || size.y > room.y || !voxels.accepts(p)) continue;
        ASSERT_TRUE(seen.count({p.origin.x, p.origin.y, p.origin.z, size.x, size.y, size.z}))
            << "seed 6, round " << round;
      }
    }
  }
}

TEST(UsefulSpaces, keepEverythingThatCanHoldARemainingItem) {
  std::mt19937_64 rng(8);
  std::size_t dropped = 0;
  for (int round = 0; round < 2000; ++round) {
    const PalletRules rules{{draw(rng, 3, 8), draw(rng, 3, 8), draw(rng, 2, 6)}};
    const PalletState state = test::randomPallet(rules, rng, draw(rng, 0, 15), 4);
    const std::vector<ItemType> types{randomType(rng), randomType(rng)};
    const std::vector<int> counts{draw(rng, 0, 1), draw(rng, 0, 1)};
    const auto useful = usefulSpaces(state, remainingLimits(types, counts));
    dropped += state.spaces().size() - useful.size();
    for (const Space& space : state.spaces()) {
      const bool kept = std::find(useful.begin(), useful.end(), space) != useful.end();
      for (std::size_t t = 0; t < types.size(); ++t) {
        for (const Vec3& size : orientations(types[t])) {
          const Vec3 room = space.size();
          const bool holds = size.x <= room.x && size.y <= room.y && size.z <= room.z;
          ASSERT_TRUE(kept || counts[t] == 0 || !holds) << "seed 8, round " << round;
        }
      }
    }
    if (counts[0] + counts[1] == 0) {
      ASSERT_TRUE(useful.empty());
    }
  }
  EXPECT_GT(dropped, 0U);
  EXPECT_THROW(remainingLimits({{"A", {1, 1, 1}, {}}}, {}), std::invalid_argument);
}

TEST(PlacementRule, isParsedFromItsWord) {
  EXPECT_EQ(placementRuleFromString("dblf"), PlacementRule::kDblf);
  EXPECT_EQ(placementRuleFromString("distance"), PlacementRule::kDistance);
  EXPECT_FALSE(placementRuleFromString("DBLF"));
  EXPECT_FALSE(placementRuleFromString(""));
}

}  // namespace
}  // namespace mixed_palletizing::packing
