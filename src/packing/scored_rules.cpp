#include "scored_rules.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace mixed_palletizing::packing {

namespace {

/// Length of the common part of two intervals.
std::int64_t common(int a_begin, int a_length, int b_begin, int b_length) {
  return std::max(0, std::min(a_begin + a_length, b_begin + b_length) - std::max(a_begin, b_begin));
}

bool meets(int a_begin, int a_length, int b_begin, int b_length) {
  return a_begin + a_length == b_begin || b_begin + b_length == a_begin;
}

/// Area of the sides of `a` that `b` touches.
std::int64_t touching(const Placement& a, const Placement& b) {
  const std::int64_t up = common(a.origin.z, a.size.z, b.origin.z, b.size.z);
  if (up == 0) return 0;
  std::int64_t area = 0;
  if (meets(a.origin.x, a.size.x, b.origin.x, b.size.x))
    area += common(a.origin.y, a.size.y, b.origin.y, b.size.y);
  if (meets(a.origin.y, a.size.y, b.origin.y, b.size.y))
    area += common(a.origin.x, a.size.x, b.origin.x, b.size.x);
  return area * up;
}

using Strips = std::pair<int, int>;  ///< free beside a box in its space, the narrower first

Strips stripsIn(const Space& space, const Placement& p) {
  const Vec3 room = space.size();
  return std::minmax({room.x - p.size.x, room.y - p.size.y});
}

bool liesIn(const Placement& p, const Space& s) {
  return p.origin.x >= s.min.x && p.origin.y >= s.min.y && p.origin.z == s.min.z &&
         p.origin.x + p.size.x <= s.max.x && p.origin.y + p.size.y <= s.max.y &&
         p.origin.z + p.size.z <= s.max.z;
}

}  // namespace

double touchingShare(const PalletState& state, const Placement& p) {
  const Vec3& pallet = state.rules().size;
  std::int64_t area = 0;
  if (p.origin.x == 0) area += static_cast<std::int64_t>(p.size.y) * p.size.z;
  if (p.origin.y == 0) area += static_cast<std::int64_t>(p.size.x) * p.size.z;
  if (p.origin.x + p.size.x == pallet.x) area += static_cast<std::int64_t>(p.size.y) * p.size.z;
  if (p.origin.y + p.size.y == pallet.y) area += static_cast<std::int64_t>(p.size.x) * p.size.z;
  for (const Placement& other : state.placements()) area += touching(p, other);
  const std::int64_t sides = 2 * static_cast<std::int64_t>(p.size.x + p.size.y) * p.size.z;
  return static_cast<double>(area) / static_cast<double>(sides);
}

std::vector<Placement> allCorners(const PalletState& state, const std::vector<Vec3>& sizes, int type) {
  std::vector<Placement> placements;
  for (const Space& space : state.spaces()) {
    const Vec3 room = space.size();
    for (const Vec3& size : sizes) {
      if (size.x > room.x || size.y > room.y || size.z > room.z) continue;
      for (const int y : {space.min.y, space.max.y - size.y}) {
        for (const int x : {space.min.x, space.max.x - size.x}) {
          placements.push_back({type, {x, y, space.min.z}, size});
        }
      }
    }
  }
  return placements;
}

const Placement* mostTouching(const PalletState& state, const std::vector<Placement>& placements) {
  const Placement* best = nullptr;
  double best_share = -1.0;
  for (const Placement& p : placements) {
    const double share = touchingShare(state, p);
    if (share <= best_share) continue;
    best = &p;
    best_share = share;
  }
  return best;
}

const Placement* bestFitting(const PalletState& state, const std::vector<Placement>& placements) {
  const Placement* best = nullptr;
  Strips best_strips{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
  for (const Placement& p : placements) {
    for (const Space& space : state.spaces()) {
      if (!liesIn(p, space)) continue;
      const Strips strips = stripsIn(space, p);
      if (strips >= best_strips) continue;
      best = &p;
      best_strips = strips;
    }
  }
  return best;
}

}  // namespace mixed_palletizing::packing
