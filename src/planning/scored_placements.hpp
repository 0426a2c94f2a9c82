// The pairs of an available item and a placement, as the policy rates them.
#pragma once

#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/planning/gripper_envelope.hpp>
#include <mixed_palletizing/planning/placement_policy.hpp>

namespace mixed_palletizing::planning {

struct ScoredPlacement {
  packing::Placement placement;
  double score = 0.0;
};

/// Which placements are tried.
enum class Trials {
  kQuick,  ///< in every space the one at the corner nearest to the origin; where that one breaks a rule, the
           ///< first at another corner that keeps all
  kThorough,  ///< at every corner of every space; where a space may not carry a box everywhere, also flush with the
              ///< edges of the tops below: packing::cornerPlacements()
};

/// Placements of an item that may stand in `sizes` which the gripper reaches; with full support each once. When `stop`
/// cuts kThorough short, those found until then.
void placementsOf(const packing::PalletState& pallet, const std::vector<packing::Vec3>& sizes, int type,
                  Trials trials, const GripperEnvelope& gripper, std::vector<packing::Placement>& placements,
                  const packing::StopCallback& stop = {});

/// All placements (kThorough) of one item of each type in `types` (sorted, distinct), best first. `remaining` is the
/// count per type with these items. When `stop` cuts in, those rated until then.
std::vector<ScoredPlacement> scoredPlacements(const packing::PalletState& pallet,
                                              const std::vector<int>& types, std::vector<int> remaining,
                                              const GripperEnvelope& gripper, PlacementPolicy& policy,
                                              const packing::StopCallback& stop);

}  // namespace mixed_palletizing::planning
