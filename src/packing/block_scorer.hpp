// How well blocks go into a space: volume, loss and contact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

#include "block_state.hpp"

namespace mixed_palletizing::packing {

/// A space and the corner of its base where blocks go: the one nearest to a corner of the pallet.
struct AnchoredSpace {
  Space space;
  bool at_max_x = false;
  bool at_max_y = false;

  Vec3 originOf(const Vec3& size) const {
    return {at_max_x ? space.max.x - size.x : space.min.x, at_max_y ? space.max.y - size.y : space.min.y,
            space.min.z};
  }
};

struct ScoredBlock {
  double score = 0.0;
  std::size_t block = 0;  ///< index in BlockCatalog::blocks
};

/// For every length up to the pallet's, the longest sum of item sides along an axis that does not exceed it.
class ReachableLengths {
 public:
  ReachableLengths(const BlockCatalog& catalog, const std::vector<int>& counts);

  int along(int axis, int length) const {
    return longest_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(length)];
  }

 private:
  std::array<std::vector<int>, 3> longest_;
};

struct ScoreWeights {
  double contact_tolerance = 0.04;  ///< p: a gap up to this share of the block's depth counts as contact
  double items_exponent = 0.2;      ///< gamma: few items are better
};

class BlockScorer {
 public:
  BlockScorer(const BlockCatalog& catalog, const ReachableLengths& lengths, const ScoreWeights& weights)
      : catalog_(catalog), lengths_(lengths), weights_(weights) {}

  /// The `count` best blocks for the space, best first; empty when none fits.
  const std::vector<ScoredBlock>& best(const BlockState& state, const AnchoredSpace& where,
                                       std::size_t count);

 private:
  /// What stands beside a space, seen from its anchor: an interval along the side, one upwards, and the
  /// distance from the side at the anchor.
  struct Neighbor {
    int begin, end, bottom, top, distance;
  };

  void lookAround(const BlockState& state, const AnchoredSpace& where);
  double reachedVolume(const Vec3& room, const Vec3& size) const;
  double contactArea(const Vec3& room, const Vec3& size) const;
  std::int64_t sideContact(std::size_t axis, int depth, int length, int height) const;
  void keep(const ScoredBlock& scored, std::size_t count);

  const BlockCatalog& catalog_;
  const ReachableLengths& lengths_;
  ScoreWeights weights_;
  std::array<std::vector<Neighbor>, 2> near_;  ///< across x, across y: on the anchor's side
  std::array<std::vector<Neighbor>, 2> far_;   ///< on the other side
  std::vector<ScoredBlock> best_;              ///< a heap, the worst in front
};

}  // namespace mixed_palletizing::packing
