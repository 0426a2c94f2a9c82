// Blocks: cuboids built of items without holes, so that a block stands like one box and its whole top supports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

struct TypeCount {
  int type = 0;
  int count = 0;

  friend bool operator==(const TypeCount& a, const TypeCount& b) {
    return a.type == b.type && a.count == b.count;
  }
};

/// One item, or two smaller blocks side by side (axis 0 along x, 1 along y) or on top of each other (2).
struct Block {
  Vec3 size;
  std::vector<TypeCount> needs;  ///< ascending by type
  int items = 1;
  int axis = -1;           ///< -1: one item
  std::size_t first = 0;   ///< index of the part nearer the origin, when there are two
  std::size_t second = 0;  ///< index of the other
};

/// All blocks that fit the pallet and the counts, at most `max_blocks`: those of few items first. The parts of
/// a block stand before it.
std::vector<Block> makeBlocks(const std::vector<ItemType>& types, const std::vector<int>& counts,
                              const Vec3& pallet, std::size_t max_blocks);

/// Appends the items of blocks[index] with its corner at `origin`, in an order in which they can be loaded.
void appendItems(const std::vector<Block>& blocks, std::size_t index, const Vec3& origin,
                 std::vector<Placement>& placements);

}  // namespace mixed_palletizing::packing
