#include "judged_places.hpp"

#include <algorithm>
#include <map>

#include "level_spaces.hpp"
#include "placement_check.hpp"

namespace mixed_palletizing::packing {
namespace {

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

/// The placed boxes by the height of their tops: what a place on a level is judged by.
class Tops {
 public:
  explicit Tops(const PalletState& state) : state_(state) {
    for (const Placement& p : state.placements()) by_height_[p.origin.z + p.size.z].push_back(p);
  }

  const std::vector<Placement>& at(int height) const {
    static const std::vector<Placement> kNone;
    const auto found = by_height_.find(height);
    return found == by_height_.end() ? kNone : found->second;
  }

  /// PalletState::acceptsInSpace(); most places fail for their support already.
  bool accept(const Placement& placement) const {
    return isSupported(state_.rules(), at(placement.origin.z), placement) && state_.acceptsInSpace(placement);
  }

 private:
  const PalletState& state_;
  std::map<int, std::vector<Placement>> by_height_;
};

/// A place in a space that is yet to be judged; of one place, the size listed first goes first.
struct Try {
  Placement placement;
  std::size_t size_index = 0;
};

/// Positions to be judged of one size in one space where not every place keeps the rules.
void addTries(const PalletState& state, const std::vector<Placement>& tops, const Space& space,
              const Vec3& size, int type, std::size_t size_index, std::vector<Try>& tries) {
  if (!fits(size, space)) return;
  std::vector<int> xs{space.min.x};
  std::vector<int> ys{space.min.y};
  const Rect base{space.min.x, space.min.y, space.max.x, space.max.y};
  if (space.min.z == 0 && state.rules().overhang > 0) {
    addStarts(base.x0, base.x1, size.x, 0, state.rules().size.x, xs);
    addStarts(base.y0, base.y1, size.y, 0, state.rules().size.y, ys);
  }
  for (const Placement& below : tops) {
    const Rect top = footprintOf(below);
    if (!top.overlaps(base)) continue;
    addStarts(base.x0, base.x1, size.x, top.x0, top.x1, xs);
    addStarts(base.y0, base.y1, size.y, top.y0, top.y1, ys);
  }
  sortUnique(xs);
  sortUnique(ys);
  for (const int y : ys) {
    for (const int x : xs) tries.push_back({{type, {x, y, space.min.z}, size}, size_index});
  }
}

/// In the spaces [first, last), until `stop` says so.
std::vector<Try> triesIn(const PalletState& state, const Tops& tops, const Space* first, const Space* last,
                         const std::vector<Vec3>& sizes, int type, const std::function<bool()>& stop) {
  std::vector<Try> tries;
  for (; first != last && !(stop && stop()); ++first) {
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      addTries(state, tops.at(first->min.z), *first, sizes[i], type, i, tries);
    }
  }
  return tries;
}

/// Few are judged: in the order of the rule, each once though many spaces offer it.
std::optional<Placement> firstAccepted(const Tops& tops, std::vector<Try> tries, bool by_distance,
                                       const std::function<bool()>& stop) {
  const auto key = [by_distance](const Try& t) {
    const Vec3& origin = t.placement.origin;
    const std::int64_t distance = by_distance ? squaredDistance(origin) : 0;
    return std::make_tuple(distance, dblfKey(origin), t.size_index);
  };
  std::sort(tries.begin(), tries.end(), [&](const Try& a, const Try& b) { return key(a) < key(b); });
  const Try* last = nullptr;
  for (const Try& t : tries) {
    if (last != nullptr && key(*last) == key(t)) continue;
    last = &t;
    if (stop && stop()) return std::nullopt;
    if (tops.accept(t.placement)) return t.placement;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Placement> judgedPlacements(const PalletState& state, const std::vector<Vec3>& sizes, int type,
                                        const std::function<bool()>& stop) {
  std::vector<Placement> placements;
  const Tops tops(state);
  const Space* const first = state.spaces().data();
  for (const Try& t : triesIn(state, tops, first, first + state.spaces().size(), sizes, type, stop)) {
    if (stop && stop()) break;
    if (tops.accept(t.placement)) placements.push_back(t.placement);
  }
  return placements;
}

/// Level by level, as most of the higher ones are never looked at.
std::optional<Placement> deepestJudged(const PalletState& state, const std::vector<Vec3>& sizes, int type,
                                       const std::function<bool()>& stop) {
  const Tops tops(state);
  const Space* const end = state.spaces().data() + state.spaces().size();
  for (const Space* first = state.spaces().data(); first != end;) {  // ordered by height first
    const int level = first->min.z;
    const Space* const last = std::find_if(first, end, [level](const Space& s) { return s.min.z != level; });
    auto found = firstAccepted(tops, triesIn(state, tops, first, last, sizes, type, stop), false, stop);
    if (found) return found;
    first = last;
  }
  return std::nullopt;
}

std::optional<Placement> nearestJudged(const PalletState& state, const std::vector<Vec3>& sizes, int type,
                                       const std::function<bool()>& stop) {
  const Space* const first = state.spaces().data();
  const Space* const last = first + state.spaces().size();
  const Tops tops(state);
  return firstAccepted(tops, triesIn(state, tops, first, last, sizes, type, stop), true, stop);
}

}  // namespace mixed_palletizing::packing
