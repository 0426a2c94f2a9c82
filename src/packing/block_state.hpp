// A pallet under construction by blocks: what the block search copies and extends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

#include "block.hpp"

namespace mixed_palletizing::packing {

/// Three lengths below 2^15 in one word, so that "fits into" is one subtraction.
class PackedSize {
 public:
  PackedSize() = default;
  explicit PackedSize(const Vec3& v)
      : word_(static_cast<std::uint64_t>(v.x) | (static_cast<std::uint64_t>(v.y) << 16U) |
              (static_cast<std::uint64_t>(v.z) << 32U)) {}

  bool fitsInto(const PackedSize& room) const {
    return (((room.word_ | kBorrow) - word_) & kBorrow) == kBorrow;
  }

 private:
  static constexpr std::uint64_t kBorrow = (1ULL << 15U) | (1ULL << 31U) | (1ULL << 47U);
  std::uint64_t word_ = 0;
};

/// A block as the scoring reads it.
struct RankedBlock {
  Vec3 size;
  std::uint32_t index = 0;  ///< in BlockCatalog::blocks
  double value = 0.0;       ///< packed volume, less for many items
  double inverse_surface = 0.0;
};

/// What all states of one search share.
struct BlockCatalog {
  Vec3 pallet;
  std::vector<Block> blocks;
  std::vector<RankedBlock> ranked;                ///< all blocks by falling value
  std::vector<PackedSize> sizes;                  ///< of ranked
  std::vector<std::vector<std::uint16_t>> needs;  ///< [type][rank]: items of the type, at most kManyItems
  std::vector<std::vector<Vec3>> orientations;    ///< of every type
  std::vector<std::pair<PackedSize, std::size_t>> orientations_by_volume;  ///< rising; with the type

  static constexpr int kManyItems = 0xffff;
};

/// A block is worth its volume over items^items_exponent.
BlockCatalog makeCatalog(const Vec3& pallet, const std::vector<ItemType>& types,
                         const std::vector<int>& counts, std::size_t max_blocks, double items_exponent);

struct BlockStep {
  std::size_t block = 0;  ///< index in BlockCatalog::blocks
  Vec3 origin;
};

class BlockState {
 public:
  BlockState(const BlockCatalog& catalog, const std::vector<int>& counts);

  const std::vector<Space>& spaces() const { return spaces_; }
  const std::vector<Space>& standing() const { return standing_; }    ///< the blocks as cuboids
  const std::vector<std::uint32_t>& ranks() const { return ranks_; }  ///< of the blocks whose items remain
  const std::vector<BlockStep>& steps() const { return steps_; }
  const std::vector<int>& remaining() const { return remaining_; }
  std::int64_t packedVolume() const { return packed_volume_; }

  /// Some remaining item fits in.
  bool isUseful(const Space& space) const;

  /// Puts a block into a space, its items being there.
  void place(const BlockCatalog& catalog, const BlockStep& step);

  /// Equal for states with the same spaces and remaining items.
  std::uint64_t fingerprint() const;

 private:
  void collectSmallest(const BlockCatalog& catalog);

  std::vector<Space> spaces_;
  std::vector<Space> standing_;
  std::vector<int> remaining_;
  std::vector<std::uint32_t> ranks_;
  std::vector<PackedSize> smallest_;  ///< orientations of remaining items that contain no other
  std::vector<BlockStep> steps_;
  std::int64_t packed_volume_ = 0;
};

}  // namespace mixed_palletizing::packing
