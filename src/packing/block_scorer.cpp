// Source: VCS of Araya, Guerrero and Nunez (2017): a block b in a space r is worth
//   V(b) * (1 - loss)^beta * contact^alpha / items^gamma, alpha = 4, beta = 1, gamma = 0.2, p = 0.04,
// V the packed volume; loss the share of the space that sums of item sides cannot reach beside and above the block;
// contact the share of the block's surface that touches boxes or walls, gaps up to p of its depth included.
#include "block_scorer.hpp"

#include <algorithm>
#include <numeric>

namespace mixed_palletizing::packing {

namespace {

constexpr int kFar = 1 << 28;  ///< beyond every pallet: the extent of a wall

int side(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Marks the sums of the sides that up to `count` items of one type can add to `reached` (units of length).
void addSums(int length, int count, std::vector<char>& reached) {
  std::vector<int> used(reached.size(), 0);
  for (std::size_t sum = static_cast<std::size_t>(length); sum < reached.size(); ++sum) {
    const std::size_t before = sum - static_cast<std::size_t>(length);
    if (reached[sum] || !reached[before] || used[before] >= count) continue;
    reached[sum] = 1;
    used[sum] = used[before] + 1;
  }
}

std::vector<int> sidesAlong(const std::vector<Vec3>& sizes, int axis) {
  std::vector<int> sides;
  for (const Vec3& size : sizes) sides.push_back(side(size, axis));
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

}  // namespace

ReachableLengths::ReachableLengths(const BlockCatalog& catalog, const std::vector<int>& counts) {
  int unit = 0;
  for (const std::vector<Vec3>& sizes : catalog.orientations) {
    for (const Vec3& size : sizes) unit = std::gcd(unit, std::gcd(size.x, std::gcd(size.y, size.z)));
  }
  unit = std::max(unit, 1);
  for (int axis = 0; axis < 3; ++axis) {
    const int length = side(catalog.pallet, axis);
    std::vector<char> reached(static_cast<std::size_t>(length / unit) + 1, 0);
    reached[0] = 1;
    for (std::size_t t = 0; t < counts.size(); ++t) {
      if (counts[t] <= 0) continue;
      for (const int s : sidesAlong(catalog.orientations[t], axis)) addSums(s / unit, counts[t], reached);
    }
    std::vector<int>& longest = longest_[static_cast<std::size_t>(axis)];
    longest.assign(static_cast<std::size_t>(length) + 1, 0);
    for (int l = 1; l <= length; ++l) {
      const bool reachable = l % unit == 0 && reached[static_cast<std::size_t>(l / unit)];
      longest[static_cast<std::size_t>(l)] = reachable ? l : longest[static_cast<std::size_t>(l) - 1];
    }
  }
}

const std::vector<ScoredBlock>& BlockScorer::best(const BlockState& state, const AnchoredSpace& where,
                                                  std::size_t count) {
  best_.clear();
  const Vec3 room = where.space.size();
  const PackedSize packed_room(room);
  const double inverse_volume = 1.0 / static_cast<double>(volume(room));
  double worst = -1.0;
  bool looked = false;
  for (const std::uint32_t rank : state.ranks()) {
    if (!catalog_.sizes[rank].fitsInto(packed_room)) continue;
    const RankedBlock& block = catalog_.ranked[rank];
    if (block.value <= worst) break;  // no later block can be better
    double score = block.value * inverse_volume * reachedVolume(room, block.size);
    if (score <= worst) continue;
    if (!looked) lookAround(state, where);
    looked = true;
    const double share = contactArea(room, block.size) * block.inverse_surface;
    score *= share * share * share * share;
    if (score <= worst) continue;
    keep({score, block.index}, count);
    if (best_.size() == count) worst = best_.front().score;
  }
  std::sort(best_.begin(), best_.end(),
            [](const ScoredBlock& a, const ScoredBlock& b) { return a.score > b.score; });
  return best_;
}

void BlockScorer::keep(const ScoredBlock& scored, std::size_t count) {
  const auto better = [](const ScoredBlock& a, const ScoredBlock& b) { return a.score > b.score; };
  best_.push_back(scored);
  std::push_heap(best_.begin(), best_.end(), better);
  if (best_.size() <= count) return;
  std::pop_heap(best_.begin(), best_.end(), better);
  best_.pop_back();
}

/// Of the room, what sums of item sides reach beside and above a block.
double BlockScorer::reachedVolume(const Vec3& room, const Vec3& size) const {
  return static_cast<double>(size.x + lengths_.along(0, room.x - size.x)) *
         static_cast<double>(size.y + lengths_.along(1, room.y - size.y)) *
         static_cast<double>(size.z + lengths_.along(2, room.z - size.z));
}

void BlockScorer::lookAround(const BlockState& state, const AnchoredSpace& where) {
  const Space& r = where.space;
  const Vec3 room = r.size();
  const bool at_max[2] = {where.at_max_x, where.at_max_y};
  for (int axis = 0; axis < 2; ++axis) {
    const std::size_t a = static_cast<std::size_t>(axis);
    const int below = side(r.min, axis);
    const int above = side(catalog_.pallet, axis) - side(r.max, axis);
    near_[a].assign(1, {-kFar, kFar, -kFar, kFar, at_max[axis] ? above : below});
    far_[a].assign(1, {-kFar, kFar, -kFar, kFar, side(room, axis) + (at_max[axis] ? below : above)});
  }
  for (const Space& body : state.standing()) {
    if (body.max.z <= r.min.z) continue;
    int begin[2];
    int end[2];
    for (int axis = 0; axis < 2; ++axis) {
      begin[axis] =
          at_max[axis] ? side(r.max, axis) - side(body.max, axis) : side(body.min, axis) - side(r.min, axis);
      end[axis] = begin[axis] + side(body.max, axis) - side(body.min, axis);
    }
    const int bottom = body.min.z - r.min.z;
    const int top = body.max.z - r.min.z;
    for (int axis = 0; axis < 2; ++axis) {
      const std::size_t a = static_cast<std::size_t>(axis);
      const int other = 1 - axis;
      if (end[other] <= 0 || begin[other] >= side(room, other)) continue;
      if (end[axis] <= 0) near_[a].push_back({begin[other], end[other], bottom, top, -end[axis]});
      if (begin[axis] >= side(room, axis))
        far_[a].push_back({begin[other], end[other], bottom, top, begin[axis]});
    }
  }
}

/// Of the two faces across an axis of a block of this depth, with the given length and height.
std::int64_t BlockScorer::sideContact(std::size_t axis, int depth, int length, int height) const {
  const int tolerance = static_cast<int>(weights_.contact_tolerance * depth);
  std::int64_t area = 0;
  const auto add = [&](const Neighbor& n) {
    const int along = std::min(n.end, length) - std::max(n.begin, 0);
    const int up = std::min(n.top, height) - std::max(n.bottom, 0);
    if (along > 0 && up > 0) area += static_cast<std::int64_t>(along) * up;
  };
  for (const Neighbor& n : near_[axis]) {
    if (n.distance <= tolerance) add(n);
  }
  for (const Neighbor& n : far_[axis]) {
    if (n.distance - depth <= tolerance) add(n);
  }
  return area;
}

double BlockScorer::contactArea(const Vec3& room, const Vec3& size) const {
  const std::int64_t base = static_cast<std::int64_t>(size.x) * size.y;  // touches: full support
  const bool at_ceiling = room.z - size.z <= weights_.contact_tolerance * size.z;
  return static_cast<double>((at_ceiling ? 2 * base : base) + sideContact(0, size.x, size.y, size.z) +
                             sideContact(1, size.y, size.x, size.z));
}

}  // namespace mixed_palletizing::packing
