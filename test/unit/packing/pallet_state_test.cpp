#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/pallet_state.hpp>

#include "brute_force.hpp"

namespace mixed_palletizing::packing {
namespace {

using test::bruteForceSpaces;
using test::Corners;
using test::VoxelPallet;

int draw(std::mt19937_64& rng, int low, int high) {
  return low + static_cast<int>(rng() % static_cast<std::uint64_t>(high - low + 1));
}

/// A box in a random space, mostly at one of its corners, sometimes anywhere in it.
Placement randomPlacement(const PalletState& state, std::mt19937_64& rng, int largest) {
  const Space space = state.spaces()[rng() % state.spaces().size()];
  const Vec3 room = space.size();
  Placement p;
  p.size = {draw(rng, 1, std::min(largest, room.x)), draw(rng, 1, std::min(largest, room.y)),
            draw(rng, 1, std::min(largest, room.z))};
  const auto offset = [&](int free) {
    return rng() % 3 == 0 ? draw(rng, 0, free) : (rng() % 2 == 0 ? 0 : free);
  };
  p.origin = {space.min.x + offset(room.x - p.size.x), space.min.y + offset(room.y - p.size.y), space.min.z};
  return p;
}

std::set<Corners> asSet(const std::vector<Space>& spaces) {
  std::set<Corners> set;
  for (const Space& space : spaces) set.insert(test::corners(space));
  return set;
}

/// Places and undoes at random; after every step the spaces are those of the definition. Returns placements.
int playAgainstDefinition(const PalletRules& rules, std::mt19937_64& rng) {
  PalletState state(rules);
  std::vector<std::vector<Space>> history;
  int placed = 0;
  while (!state.spaces().empty() && state.placements().size() < 40) {
    if (!history.empty() && rng() % 5 == 0) {
      EXPECT_TRUE(state.undo());
      EXPECT_TRUE(state.spaces() == history.back()) << "undo restores the spaces exactly";
      history.pop_back();
      continue;
    }
    history.push_back(state.spaces());
    state.place(randomPlacement(state, rng, 4));
    ++placed;
    const VoxelPallet voxels(rules, state.placements());
    EXPECT_FALSE(voxels.overlap());
    EXPECT_EQ(asSet(state.spaces()).size(), state.spaces().size()) << "a space is listed twice";
    EXPECT_EQ(asSet(state.spaces()), bruteForceSpaces(rules, voxels));
    if (testing::Test::HasFailure()) break;
  }
  return placed;
}

TEST(PalletState, spacesAreThoseOfTheDefinition) {
  for (const int gap : {0, 0, 0, 1, 2}) {
    std::mt19937_64 rng(11 + static_cast<unsigned>(gap));
    int placed = 0;
    for (int game = 0; placed < 30000; ++game) {
      const PalletRules rules{{draw(rng, 3, 9), draw(rng, 3, 8), draw(rng, 2, 7)}, gap, 1.0};
      placed += playAgainstDefinition(rules, rng);
      ASSERT_FALSE(HasFailure()) << "gap " << gap << ", game " << game << " of seed 11 + gap";
    }
  }
}

}  // namespace
}  // namespace mixed_palletizing::packing
