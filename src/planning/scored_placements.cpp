#include "scored_placements.hpp"

#include <algorithm>
#include <optional>

#include <mixed_palletizing/packing/placement_rule.hpp>

namespace mixed_palletizing::planning {

namespace {

bool fits(const packing::Vec3& size, const packing::Space& space) {
  const packing::Vec3 room = space.size();
  return size.x <= room.x && size.y <= room.y && size.z <= room.z;
}

/// The first corner of a space at which the box keeps all rules, the one nearest to the origin first.
std::optional<packing::Placement> atSoundCorner(const packing::PalletState& pallet,
                                                const packing::Space& space, const packing::Vec3& size,
                                                int type) {
  for (const int y : {space.min.y, space.max.y - size.y}) {
    for (const int x : {space.min.x, space.max.x - size.x}) {
      const packing::Placement placement{type, {x, y, space.min.z}, size};
      if (pallet.acceptsInSpace(placement)) return placement;
    }
  }
  return std::nullopt;
}

/// At the four corners of a space, those that are not among `placements` from `first` on. Spaces of one level
/// overlap, so that several offer one place.
void addCorners(const packing::Space& space, const packing::Vec3& size, int type, std::size_t first,
                std::vector<packing::Placement>& placements) {
  for (const int y : {space.min.y, space.max.y - size.y}) {
    for (const int x : {space.min.x, space.max.x - size.x}) {
      const packing::Placement placement{type, {x, y, space.min.z}, size};
      const auto begin = placements.begin() + static_cast<std::ptrdiff_t>(first);
      if (std::find(begin, placements.end(), placement) == placements.end()) placements.push_back(placement);
    }
  }
}

/// Those that the pallet's rules allow.
void addPlacements(const packing::PalletState& pallet, const std::vector<packing::Vec3>& sizes, int type,
                   Trials trials, const packing::StopCallback& stop,
                   std::vector<packing::Placement>& placements) {
  if (!pallet.fullSupport() && trials == Trials::kThorough) {
    placements = packing::cornerPlacements(pallet, sizes, type, stop);
    return;
  }
  for (const packing::Vec3& size : sizes) {
    std::size_t first = placements.size();  // of this size on this level
    const packing::Space* last = nullptr;
    for (const packing::Space& space : pallet.spaces()) {
      if (!fits(size, space)) continue;
      if (last == nullptr || space.min.z != last->min.z) first = placements.size();
      const bool new_corner = last == nullptr || space.min != last->min;  // those of one follow each other
      last = &space;
      if (!pallet.fullSupport()) {
        const auto placement = atSoundCorner(pallet, space, size, type);
        if (placement && (placements.empty() || !(placements.back() == *placement))) {
          placements.push_back(*placement);
        }
      } else if (trials == Trials::kThorough) {
        addCorners(space, size, type, first, placements);
      } else if (new_corner) {
        placements.push_back({type, space.min, size});
      }
    }
  }
}

}  // namespace

void placementsOf(const packing::PalletState& pallet, const std::vector<packing::Vec3>& sizes, int type,
                  Trials trials, const GripperEnvelope& gripper, std::vector<packing::Placement>& placements,
                  const packing::StopCallback& stop) {
  placements.clear();
  if (!pallet.carriesWeightOf(type)) return;
  addPlacements(pallet, sizes, type, trials, stop, placements);
  if (!gripper.isThere()) return;
  const auto touches = [&](const packing::Placement& p) { return !clears(gripper, pallet, p); };
  placements.erase(std::remove_if(placements.begin(), placements.end(), touches), placements.end());
}

std::vector<ScoredPlacement> scoredPlacements(const packing::PalletState& pallet,
                                              const std::vector<int>& types, std::vector<int> remaining,
                                              const GripperEnvelope& gripper, PlacementPolicy& policy,
                                              const packing::StopCallback& stop) {
  std::vector<ScoredPlacement> scored;
  std::vector<packing::Placement> placements;
  bool stopped = false;
  for (const int type : types) {
    stopped = stopped || (stop && stop());
    if (stopped) break;
    placementsOf(pallet, policy.sizes(type), type, Trials::kThorough, gripper, placements, stop);
    --remaining[static_cast<std::size_t>(type)];
    policy.prepare(pallet, remaining);
    for (const packing::Placement& placement : placements) {
      stopped = stop && stop();
      if (stopped) break;
      scored.push_back({placement, policy.score(placement)});
    }
    ++remaining[static_cast<std::size_t>(type)];
  }
  std::stable_sort(scored.begin(), scored.end(),
                   [](const ScoredPlacement& a, const ScoredPlacement& b) { return a.score > b.score; });
  return scored;
}

}  // namespace mixed_palletizing::planning
