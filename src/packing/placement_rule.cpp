// Source: DBLF (Karabulut and Inceoglu 2004) and the distance rule as in thesis 3.3.1 and 4.2.3; the axes are
// ours: deepest = lowest z, then smallest y, then smallest x.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <tuple>

#include <mixed_palletizing/packing/placement_rule.hpp>

#include "level_spaces.hpp"
#include "scored_rules.hpp"

namespace mixed_palletizing::packing {

namespace {

bool fits(const Vec3& size, const Space& space) {
  return size.x <= space.max.x - space.min.x && size.y <= space.max.y - space.min.y &&
         size.z <= space.max.z - space.min.z;
}

auto dblfKey(const Vec3& origin) { return std::make_tuple(origin.z, origin.y, origin.x); }

std::int64_t squaredDistance(const Vec3& p) {
  const auto square = [](int v) { return static_cast<std::int64_t>(v) * v; };
  return square(p.x) + square(p.y) + square(p.z);
}

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

/// Starts along one axis in [low, high - length]: the corner first, then flush with the edges of tops.
void addStarts(int low, int high, int length, int top_begin, int top_end, std::vector<int>& starts) {
  for (const int start : {low, top_begin, top_end - length, high - length}) {
    if (start >= low && start <= high - length) starts.push_back(start);
  }
}

void sortUnique(std::vector<int>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Positions to be judged of one size in one space where not every place keeps the rules.
void addTries(const PalletState& state, const Space& space, const Vec3& size, int type,
              std::vector<Placement>& tries) {
  if (!fits(size, space)) return;
  std::vector<int> xs{space.min.x};
  std::vector<int> ys{space.min.y};
  const Rect base{space.min.x, space.min.y, space.max.x, space.max.y};
  if (space.min.z == 0 && state.rules().overhang > 0) {
    addStarts(base.x0, base.x1, size.x, 0, state.rules().size.x, xs);
    addStarts(base.y0, base.y1, size.y, 0, state.rules().size.y, ys);
  }
  for (const Placement& below : state.placements()) {
    const Rect top = footprintOf(below);
    if (below.origin.z + below.size.z != space.min.z || !top.overlaps(base)) continue;
    addStarts(base.x0, base.x1, size.x, top.x0, top.x1, xs);
    addStarts(base.y0, base.y1, size.y, top.y0, top.y1, ys);
  }
  sortUnique(xs);
  sortUnique(ys);
  for (const int y : ys) {
    for (const int x : xs) tries.push_back({type, {x, y, space.min.z}, size});
  }
}

/// At the corners of the spaces; without fullSupport() some may break a rule.
std::vector<Placement> allTries(const PalletState& state, const std::vector<Vec3>& sizes, int type) {
  std::vector<Placement> tries;
  if (!state.carriesWeightOf(type)) return tries;
  for (const Space& space : state.spaces()) {
    for (const Vec3& size : sizes) {
      if (!state.fullSupport()) {
        addTries(state, space, size, type, tries);
      } else if (fits(size, space)) {
        tries.push_back({type, space.min, size});
      }
    }
  }
  return tries;
}

/// Those not yet judged when `stop` says so are left out.
std::vector<Placement> allPlacements(const PalletState& state, const std::vector<Vec3>& sizes, int type,
                                     const std::function<bool()>& stop = {}) {
  std::vector<Placement> placements = allTries(state, sizes, type);
  if (state.fullSupport()) return placements;
  const auto refused = [&](const Placement& p) { return (stop && stop()) || !state.accepts(p); };
  placements.erase(std::remove_if(placements.begin(), placements.end(), refused), placements.end());
  return placements;
}

/// By kContact or kBestFit.
std::optional<Placement> bestScored(const PalletState& state, const std::vector<Placement>& placements,
                                    PlacementRule rule) {
  const Placement* best =
      rule == PlacementRule::kContact ? mostTouching(state, placements) : bestFitting(state, placements);
  return best == nullptr ? std::nullopt : std::make_optional(*best);
}

/// By kDblf or kDistance, where places must be judged: few of them, in the order of the rule.
std::optional<Placement> firstAccepted(const PalletState& state, std::vector<Placement> tries,
                                       PlacementRule rule) {
  const auto before = [rule](const Placement& a, const Placement& b) {
    const std::int64_t distance_a = rule == PlacementRule::kDistance ? squaredDistance(a.origin) : 0;
    const std::int64_t distance_b = rule == PlacementRule::kDistance ? squaredDistance(b.origin) : 0;
    return std::make_tuple(distance_a, dblfKey(a.origin)) < std::make_tuple(distance_b, dblfKey(b.origin));
  };
  std::stable_sort(tries.begin(), tries.end(), before);
  const auto first =
      std::find_if(tries.begin(), tries.end(), [&](const Placement& p) { return state.accepts(p); });
  return first == tries.end() ? std::nullopt : std::make_optional(*first);
}

/// By kDblf, where places must be judged: level by level, as most of the higher ones are never looked at.
std::optional<Placement> deepestAccepted(const PalletState& state, const std::vector<Vec3>& sizes, int type) {
  const std::vector<Space>& spaces = state.spaces();  // ordered by height first
  for (std::size_t first = 0; first < spaces.size();) {
    std::vector<Placement> tries;
    const int level = spaces[first].min.z;
    for (; first < spaces.size() && spaces[first].min.z == level; ++first) {
      for (const Vec3& size : sizes) addTries(state, spaces[first], size, type, tries);
    }
    if (auto found = firstAccepted(state, std::move(tries), PlacementRule::kDblf)) return found;
  }
  return std::nullopt;
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
                                       int type_index, PlacementRule rule) {
  checkItem(sizes, type_index, "findPlacement");
  if (!state.carriesWeightOf(type_index)) return std::nullopt;
  if (rule == PlacementRule::kContact || rule == PlacementRule::kBestFit) {
    const bool anywhere = state.fullSupport();
    return bestScored(
        state, anywhere ? allCorners(state, sizes, type_index) : allPlacements(state, sizes, type_index),
        rule);
  }
  if (!state.fullSupport() && rule == PlacementRule::kDblf) return deepestAccepted(state, sizes, type_index);
  if (!state.fullSupport()) return firstAccepted(state, allTries(state, sizes, type_index), rule);
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
