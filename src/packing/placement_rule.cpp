// Source: DBLF (Karabulut and Inceoglu 2004) and the distance rule as in thesis 3.3.1 and 4.2.3; the axes are
// ours: deepest = lowest z, then smallest y, then smallest x.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <tuple>

#include <mixed_palletizing/packing/placement_rule.hpp>

#include "judged_places.hpp"
#include "scored_rules.hpp"

namespace mixed_palletizing::packing {

namespace {

/// The first size that fits at the corner of spaces[first], among all spaces with that corner.
const Vec3* sizeAtCorner(const std::vector<Space>& spaces, std::size_t first,
                         const std::vector<Vec3>& sizes) {
  for (const Vec3& size : sizes) {
    for (std::size_t i = first; i < spaces.size() && spaces[i].min == spaces[first].min; ++i) {
      if (fits(size, spaces[i])) return &size;
    }
  }
  return nullptr;
}

std::optional<Placement> deepest(const std::vector<Space>& spaces, const std::vector<Vec3>& sizes, int type) {
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    if (const Vec3* size = sizeAtCorner(spaces, i, sizes)) return Placement{type, spaces[i].min, *size};
  }
  return std::nullopt;
}

std::optional<Placement> nearest(const std::vector<Space>& spaces, const std::vector<Vec3>& sizes, int type) {
  std::optional<Placement> best;
  std::int64_t best_distance = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    const std::int64_t distance = squaredDistance(spaces[i].min);
    if (distance >= best_distance) continue;
    if (const Vec3* size = sizeAtCorner(spaces, i, sizes)) {
      best = Placement{type, spaces[i].min, *size};
      best_distance = distance;
    }
  }
  return best;
}

/// At the corners of the spaces, each as often as spaces offer it; without fullSupport() as far as the rules allow. Those
/// not yet judged when `stop` says so are left out.
std::vector<Placement> allPlacements(const PalletState& state, const std::vector<Vec3>& sizes, int type,
                                     const std::function<bool()>& stop = {}) {
  if (!state.carriesWeightOf(type)) return {};
  if (!state.fullSupport()) return judgedPlacements(state, sizes, type, stop);
  std::vector<Placement> placements;
  for (const Space& space : state.spaces()) {
    for (const Vec3& size : sizes) {
      if (fits(size, space)) placements.push_back({type, space.min, size});
    }
  }
  return placements;
}

/// By kContact or kBestFit.
std::optional<Placement> bestScored(const PalletState& state, const std::vector<Placement>& placements,
                                    PlacementRule rule) {
  const Placement* best =
      rule == PlacementRule::kContact ? mostTouching(state, placements) : bestFitting(state, placements);
  return best == nullptr ? std::nullopt : std::make_optional(*best);
}

void checkItem(const std::vector<Vec3>& sizes, int type, const char* function) {
  if (type < 0) {
    throw std::invalid_argument(std::string(function) + ": type_index " + std::to_string(type) +
                                " is negative");
  }
  for (const Vec3& size : sizes) {
    if (size.x > 0 && size.y > 0 && size.z > 0) continue;
    throw std::invalid_argument(std::string(function) + ": size " + std::to_string(size.x) + " x " +
                                std::to_string(size.y) + " x " + std::to_string(size.z) +
                                " mm is not positive");
  }
}

}  // namespace

std::optional<PlacementRule> placementRuleFromString(const std::string& word) {
  if (word == "dblf") return PlacementRule::kDblf;
  if (word == "distance") return PlacementRule::kDistance;
  if (word == "contact") return PlacementRule::kContact;
  if (word == "best_fit") return PlacementRule::kBestFit;
  return std::nullopt;
}

std::optional<Placement> findPlacement(const PalletState& state, const ItemType& type, int type_index,
                                       PlacementRule rule) {
  return findPlacement(state, orientations(type), type_index, rule);
}

std::optional<Placement> findPlacement(const PalletState& state, const std::vector<Vec3>& sizes,
                                       int type_index, PlacementRule rule,
                                       const std::function<bool()>& stop) {
  checkItem(sizes, type_index, "findPlacement");
  if (!state.carriesWeightOf(type_index)) return std::nullopt;
  if (rule == PlacementRule::kContact || rule == PlacementRule::kBestFit) {
    const bool anywhere = state.fullSupport();
    return bestScored(
        state, anywhere ? allCorners(state, sizes, type_index) : allPlacements(state, sizes, type_index),
        rule);
  }
  if (!state.fullSupport() && rule == PlacementRule::kDblf) {
    return deepestJudged(state, sizes, type_index, stop);
  }
  if (!state.fullSupport()) return nearestJudged(state, sizes, type_index, stop);
  return rule == PlacementRule::kDblf ? deepest(state.spaces(), sizes, type_index)
                                      : nearest(state.spaces(), sizes, type_index);
}

std::vector<Placement> cornerPlacements(const PalletState& state, const ItemType& type, int type_index) {
  return cornerPlacements(state, orientations(type), type_index);
}

std::vector<Placement> cornerPlacements(const PalletState& state, const std::vector<Vec3>& sizes,
                                        int type_index, const std::function<bool()>& stop) {
  checkItem(sizes, type_index, "cornerPlacements");
  std::vector<Placement> placements = allPlacements(state, sizes, type_index, stop);
  const auto key = [](const Placement& p) { return std::make_tuple(dblfKey(p.origin), dblfKey(p.size)); };
  std::sort(placements.begin(), placements.end(),
            [&](const Placement& a, const Placement& b) { return key(a) < key(b); });
  placements.erase(std::unique(placements.begin(), placements.end()), placements.end());
  return placements;
}

RemainingLimits remainingLimits(const std::vector<ItemType>& types, const std::vector<int>& counts) {
  if (types.size() != counts.size()) {
    throw std::invalid_argument("remainingLimits: counts: " + std::to_string(counts.size()) + " counts for " +
                                std::to_string(types.size()) + " types");
  }
  RemainingLimits limits{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<int>::max(),
                         std::numeric_limits<int>::max()};
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (counts[i] <= 0) continue;
    limits.volume = std::min(limits.volume, volume(types[i].size));
    for (const Vec3& size : orientations(types[i])) {
      limits.footprint_side = std::min({limits.footprint_side, size.x, size.y});
      limits.height = std::min(limits.height, size.z);
    }
  }
  return limits;
}

std::vector<Space> usefulSpaces(const PalletState& state, const RemainingLimits& limits) {
  std::vector<Space> useful;
  for (const Space& space : state.spaces()) {
    const Vec3 size = space.size();
    if (volume(size) >= limits.volume && std::min(size.x, size.y) >= limits.footprint_side &&
        size.z >= limits.height) {
      useful.push_back(space);
    }
  }
  return useful;
}

}  // namespace mixed_palletizing::packing
