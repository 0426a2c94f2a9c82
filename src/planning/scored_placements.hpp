// The pairs of an available item and a placement, as the policy rates them.
#pragma once

#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/planning/placement_policy.hpp>

namespace mixed_palletizing::planning {

struct ScoredPlacement {
  packing::Placement placement;
  double score = 0.0;
};

/// Every placement of an item that may stand in `sizes` at the corner nearest to the origin of a supported
/// space, each once; below full support as packing::cornerPlacements().
void placementsOf(const packing::PalletState& pallet, const std::vector<packing::Vec3>& sizes, int type,
                  std::vector<packing::Placement>& placements);

/// All placements of one item of each type in `types` (sorted, distinct), best first. `remaining` is the count
/// per type with these items. When `stop` cuts in, those rated until then.
std::vector<ScoredPlacement> scoredPlacements(const packing::PalletState& pallet,
                                              const std::vector<int>& types, std::vector<int> remaining,
                                              PlacementPolicy& policy, const packing::StopCallback& stop);

}  // namespace mixed_palletizing::planning
