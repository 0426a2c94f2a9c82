// Random placements and undos on one pallet, each compared with the voxels and with the definition of the spaces.
#pragma once

#include <random>
#include <set>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>

#include "brute_force.hpp"
#include "random_play.hpp"

namespace mixed_palletizing::packing::test {

struct Game {
  int placed = 0;
  std::string fault;  ///< the first difference; empty when there is none
};

inline std::set<Corners> asSet(const std::vector<Space>& spaces) {
  std::set<Corners> set;
  for (const Space& space : spaces) set.insert(corners(space));
  return set;
}

/// What is wrong with the spaces of a pallet on which `voxels` stand. With partial support spaces have no definition
/// to compare with: only that none is listed twice.
inline std::string spaceFault(const PalletState& state, const VoxelPallet& voxels) {
  const std::set<Corners> spaces = asSet(state.spaces());
  if (spaces.size() != state.spaces().size()) return "a space is listed twice";
  if (state.spaceKind() == SpaceKind::kEmpty) {
    return spaces == bruteForceEmptySpaces(state.rules(), voxels) ? "" : "other empty spaces than defined";
  }
  if (state.rules().min_support_ratio < 1.0) return "";
  return spaces == bruteForceSpaces(state.rules(), voxels) ? "" : "other supported spaces than defined";
}

/// Plays until no space is left, `most` boxes stand or something differs.
inline Game playAgainstDefinition(PalletState state, std::mt19937_64& rng, std::size_t most) {
  Game game;
  std::vector<std::vector<Space>> history;
  VoxelPallet voxels(state.rules(), {});
  for (std::size_t step = 0; step < 3 * most && !state.spaces().empty() && state.placements().size() < most;
       ++step) {
    if (!history.empty() && rng() % 5 == 0) {
      if (!state.undo()) game.fault = "nothing was taken back";
      if (!(state.spaces() == history.back())) game.fault = "undo does not restore the spaces";
      history.pop_back();
      voxels = VoxelPallet(state.rules(), state.placements());
    } else {
      const Placement placement = randomPlacement(state, rng, 4);
      const bool accepted = state.accepts(placement);
      if (accepted != voxels.accepts(placement)) game.fault = "voxels and accepts() disagree";
      if (accepted != state.acceptsInSpace(placement)) game.fault = "acceptsInSpace() says otherwise";
      if (!accepted && state.fullSupport()) game.fault = "a box in a space is refused";
      if (game.fault.empty() && accepted) {
        history.push_back(state.spaces());
        state.place(placement);
        ++game.placed;
        voxels = VoxelPallet(state.rules(), state.placements());
        game.fault = voxels.overlap() ? "boxes overlap" : spaceFault(state, voxels);
      }
    }
    if (!game.fault.empty()) return game;
  }
  return game;
}

}  // namespace mixed_palletizing::packing::test
