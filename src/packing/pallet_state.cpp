// Source: empty supported maximal spaces, thesis 3.3.1.
// With full support and no gap the packed boxes fill everything below their tops, so the pallet is a height
// map and a supported maximal space is a maximal rectangle of a level set {height == z}, up to the pallet's
// height. Placing a box with footprint F from z to z + h is the five-way split: F is cut out of level z
// (left, right, front, back) and joins level z + h (above, merged with equal tops). Undo is the same with the
// levels exchanged. With a gap or partial support the levels below the new top lose F widened by the gap, and
// the level of the top is built anew from the placed boxes.
#include <algorithm>
#include <stdexcept>
#include <string>

#include <mixed_palletizing/packing/pallet_state.hpp>

#include "empty_spaces.hpp"
#include "level_spaces.hpp"
#include "maximal_rectangles.hpp"
#include "messages.hpp"
#include "placement_check.hpp"

namespace mixed_palletizing::packing {

namespace {

int topOf(const Placement& placement) { return placement.origin.z + placement.size.z; }

bool holds(const Space& space, const Placement& p) {
  return space.min.z == p.origin.z && space.min.x <= p.origin.x && space.min.y <= p.origin.y &&
         p.size.x <= space.max.x - p.origin.x && p.size.y <= space.max.y - p.origin.y &&
         p.size.z <= space.max.z - p.origin.z;
}

bool isBox(const Placement& p) { return p.type >= 0 && p.size.x > 0 && p.size.y > 0 && p.size.z > 0; }

}  // namespace

PalletState::PalletState(const PalletRules& rules) : rules_(rules) {
  throwProblems("PalletState", problems(rules));
  full_support_ = rules.min_support_ratio == 1.0;
  spaces_.push_back(rules.room());
}

PalletState::PalletState(const Order& order, SpaceKind kind) : PalletState(order.rules) {
  kind_ = kind;
  loads_ = LoadBook(order);
}

std::string PalletState::whyNot(const Placement& placement) const {
  const std::string broken = brokenRule(rules_, placements_, placement);
  return broken.empty() ? loads_.whyNot(placements_, placement) : broken;
}

bool PalletState::accepts(const Placement& placement) const {
  const bool holds_all = full_support_ && kind_ == SpaceKind::kSupported;
  const bool stands =
      !holds_all ? keepsRules(rules_, placements_, placement)
                 : isBox(placement) && std::any_of(spaces_.begin(), spaces_.end(), [&](const Space& space) {
                     return holds(space, placement);
                   });
  return stands && (!loads_.active() || loads_.carries(placements_, placement));
}

/// Supported spaces keep clear of all that rises above their base, and with full support rest on it wholly.
bool PalletState::acceptsInSpace(const Placement& placement) const {
  if (kind_ != SpaceKind::kSupported) return accepts(placement);
  if (!full_support_ && !isSupported(rules_, placements_, placement)) return false;
  return !loads_.active() || loads_.carries(placements_, placement);
}

void PalletState::place(const Placement& placement) {
  if (!accepts(placement)) throw std::invalid_argument("PalletState::place: " + whyNot(placement));
  placements_.push_back(placement);
  packed_volume_ += volume(placement.size);
  loads_.addLast(placements_);
  addObstacle(placement);
}

bool PalletState::levelsAfter(const Placement& placement, ChangedLevels& changed) const {
  if (!levelsAreIndependent() || kind_ != SpaceKind::kSupported) return false;
  thread_local std::vector<Rect> rects;
  const auto tell = [&](int z, std::vector<Space>& spaces) {
    spaces.clear();
    for (const Rect& r : rects) spaces.push_back({{r.x0, r.y0, z}, {r.x1, r.y1, rules_.size.z}});
  };
  const int top = topOf(placement);
  changed.top.clear();
  rectsOfLevel(spaces_, placement.origin.z, rects);
  cutOut(rects, footprintOf(placement));
  tell(placement.origin.z, changed.base);
  if (top >= rules_.size.z) return true;
  rectsOfLevel(spaces_, top, rects);
  addRect(rects, footprintOf(placement));
  tell(top, changed.top);
  return true;
}

bool PalletState::undo() {
  if (placements_.empty()) return false;
  const Placement placement = placements_.back();
  placements_.pop_back();
  packed_volume_ -= volume(placement.size);
  loads_.removeLast();
  removeObstacle(placement);
  return true;
}

double PalletState::utilization() const {
  return static_cast<double>(packed_volume_) / static_cast<double>(volume(rules_.size));
}

void PalletState::cutOutOfEmpty(const Placement& placement) {
  const Rect obstacle = widened(footprintOf(placement), rules_.gap);
  cutOut(spaces_,
         Space{{obstacle.x0, obstacle.y0, placement.origin.z}, {obstacle.x1, obstacle.y1, topOf(placement)}},
         removed_);
  removed_ends_.push_back(removed_.size());
}

void PalletState::restoreEmpty() {
  removed_ends_.pop_back();
  const auto first =
      removed_.begin() + static_cast<std::ptrdiff_t>(removed_ends_.empty() ? 0 : removed_ends_.back());
  restore(spaces_, {first, removed_.end()});
  removed_.erase(first, removed_.end());
}

void PalletState::addObstacle(const Placement& placement) {
  if (kind_ == SpaceKind::kEmpty) return cutOutOfEmpty(placement);
  const Rect footprint = footprintOf(placement);
  const int top = topOf(placement);
  LevelSpaces levels(spaces_, rules_.size.z);
  if (levelsAreIndependent()) {
    levels.edit(placement.origin.z, [&](std::vector<Rect>& rects) { cutOut(rects, footprint); });
    if (top < rules_.size.z) {
      levels.edit(top, [&](std::vector<Rect>& rects) { addRect(rects, footprint); });
    }
    return;
  }
  const Rect obstacle = widened(footprint, rules_.gap);
  for (const int z : levels.heights()) {
    if (z >= top) break;
    levels.edit(z, [&](std::vector<Rect>& rects) {
      cutOut(rects, obstacle);
      dropUnsupported(rects, rules_, z, placements_);
    });
  }
  rebuildLevel(top);
}

void PalletState::removeObstacle(const Placement& placement) {
  if (kind_ == SpaceKind::kEmpty) return restoreEmpty();
  const Rect footprint = footprintOf(placement);
  const int top = topOf(placement);
  LevelSpaces levels(spaces_, rules_.size.z);
  if (levelsAreIndependent()) {
    if (top < rules_.size.z) {
      levels.edit(top, [&](std::vector<Rect>& rects) { cutOut(rects, footprint); });
    }
    levels.edit(placement.origin.z, [&](std::vector<Rect>& rects) { addRect(rects, footprint); });
    return;
  }
  std::vector<int> heights{0, top};
  for (const Placement& p : placements_) heights.push_back(topOf(p));
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  for (const int z : heights) {
    if (z <= top) rebuildLevel(z);
  }
}

void PalletState::rebuildLevel(int z) {
  if (z >= rules_.size.z) return;
  LevelSpaces(spaces_, rules_.size.z).edit(z, [&](std::vector<Rect>& rects) {
    rects = supportedRects(rules_, placements_, z);
  });
}

}  // namespace mixed_palletizing::packing
