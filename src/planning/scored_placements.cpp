#include "scored_placements.hpp"

#include <algorithm>

#include <mixed_palletizing/packing/placement_rule.hpp>

namespace mixed_palletizing::planning {

void placementsOf(const packing::PalletState& pallet, const std::vector<packing::Vec3>& sizes, int type,
                  std::vector<packing::Placement>& placements) {
  placements.clear();
  if (!pallet.carriesWeightOf(type)) return;
  if (!pallet.fullSupport()) {
    placements = packing::cornerPlacements(pallet, sizes, type);
    return;
  }
  for (const packing::Vec3& size : sizes) {
    const packing::Space* last = nullptr;
    for (const packing::Space& space : pallet.spaces()) {  // spaces of one corner follow each other
      const packing::Vec3 room = space.size();
      if (size.x > room.x || size.y > room.y || size.z > room.z) continue;
      if (last != nullptr && last->min == space.min) continue;
      last = &space;
      placements.push_back({type, space.min, size});
    }
  }
}

std::vector<ScoredPlacement> scoredPlacements(const packing::PalletState& pallet,
                                              const std::vector<int>& types, std::vector<int> remaining,
                                              PlacementPolicy& policy, const packing::StopCallback& stop) {
  std::vector<ScoredPlacement> scored;
  std::vector<packing::Placement> placements;
  packing::PalletState trial = pallet;
  bool stopped = false;
  for (const int type : types) {
    if (stopped) break;
    placementsOf(pallet, policy.sizes(type), type, placements);
    --remaining[static_cast<std::size_t>(type)];
    for (const packing::Placement& placement : placements) {
      stopped = stop && stop();
      if (stopped) break;
      trial = pallet;
      trial.place(placement);
      scored.push_back({placement, policy.score(trial, placement, remaining)});
    }
    ++remaining[static_cast<std::size_t>(type)];
  }
  std::stable_sort(scored.begin(), scored.end(),
                   [](const ScoredPlacement& a, const ScoredPlacement& b) { return a.score > b.score; });
  return scored;
}

}  // namespace mixed_palletizing::planning
