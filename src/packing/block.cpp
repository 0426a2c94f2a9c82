// Source: general blocks of Fanslau and Bortfeldt (2010), here without holes: two blocks are joined along an axis when
// they agree in the other two, generation by generation.
#include "block.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace mixed_palletizing::packing {

namespace {

int& side(Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
int side(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Two lengths as one number.
std::uint64_t sectionKey(const Vec3& size, int axis) {
  return (static_cast<std::uint64_t>(side(size, (axis + 1) % 3)) << 32U) |
         static_cast<std::uint64_t>(side(size, (axis + 2) % 3));
}

std::string contentKey(const Block& block) {
  std::string key;
  const auto put = [&key](int value) { key.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(block.size.x);
  put(block.size.y);
  put(block.size.z);
  for (const TypeCount& need : block.needs) {
    put(need.type);
    put(need.count);
  }
  return key;
}

std::vector<TypeCount> sumOf(const std::vector<TypeCount>& a, const std::vector<TypeCount>& b) {
  std::vector<TypeCount> sum;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    if (j == b.size() || (i < a.size() && a[i].type < b[j].type)) {
      sum.push_back(a[i++]);
    } else if (i == a.size() || b[j].type < a[i].type) {
      sum.push_back(b[j++]);
    } else {
      sum.push_back({a[i].type, a[i].count + b[j].count});
      ++i;
      ++j;
    }
  }
  return sum;
}

class BlockMaker {
 public:
  BlockMaker(const std::vector<int>& counts, const Vec3& pallet, std::size_t max_blocks)
      : counts_(counts), pallet_(pallet), max_blocks_(max_blocks) {}

  void addItems(const std::vector<ItemType>& types) {
    for (std::size_t t = 0; t < types.size(); ++t) {
      if (counts_[t] <= 0) continue;
      for (const Vec3& size : orientations(types[t])) add({size, {{static_cast<int>(t), 1}}});
    }
  }

  /// Joins every block of the last generation with every block there is, until nothing new comes.
  void joinAll() {
    for (std::size_t next = 0; next < blocks_.size() && !full(); ++next) {
      for (int axis = 0; axis < 3; ++axis) {
        const std::vector<std::size_t>& partners =
            by_section_[static_cast<std::size_t>(axis)][sectionKey(blocks_[next].size, axis)];
        // By index and up to `next`: joining adds to the list.
        for (std::size_t k = 0; k < partners.size() && partners[k] <= next && !full(); ++k) {
          join(partners[k], next, axis);
        }
      }
    }
  }

  std::vector<Block> take() { return std::move(blocks_); }

 private:
  bool full() const { return blocks_.size() >= max_blocks_; }

  void join(std::size_t first, std::size_t second, int axis) {
    const Block& a = blocks_[first];
    const Block& b = blocks_[second];
    if (side(a.size, axis) + side(b.size, axis) > side(pallet_, axis)) return;
    Block joined{a.size, sumOf(a.needs, b.needs), a.items + b.items, axis, first, second};
    side(joined.size, axis) += side(b.size, axis);
    add(std::move(joined));
  }

  void add(Block block) {
    if (block.size.x > pallet_.x || block.size.y > pallet_.y || block.size.z > pallet_.z) return;
    for (const TypeCount& need : block.needs) {
      if (need.count > counts_[static_cast<std::size_t>(need.type)]) return;
    }
    if (full() || !known_.insert(contentKey(block)).second) return;
    for (int axis = 0; axis < 3; ++axis) {
      by_section_[static_cast<std::size_t>(axis)][sectionKey(block.size, axis)].push_back(blocks_.size());
    }
    blocks_.push_back(std::move(block));
  }

  const std::vector<int>& counts_;
  Vec3 pallet_;
  std::size_t max_blocks_;
  std::vector<Block> blocks_;
  std::unordered_set<std::string> known_;
  /// For every axis: the blocks by their section across it.
  std::array<std::unordered_map<std::uint64_t, std::vector<std::size_t>>, 3> by_section_;
};

}  // namespace

std::vector<Block> makeBlocks(const std::vector<ItemType>& types, const std::vector<int>& counts,
                              const Vec3& pallet, std::size_t max_blocks) {
  BlockMaker maker(counts, pallet, max_blocks);
  maker.addItems(types);
  maker.joinAll();
  return maker.take();
}

void appendItems(const std::vector<Block>& blocks, std::size_t index, const Vec3& origin,
                 std::vector<Placement>& placements) {
  const Block& block = blocks[index];
  if (block.axis < 0) {
    placements.push_back({block.needs[0].type, origin, block.size});
    return;
  }
  Vec3 next = origin;
  side(next, block.axis) += side(blocks[block.first].size, block.axis);
  appendItems(blocks, block.first, origin, placements);
  appendItems(blocks, block.second, next, placements);
}

}  // namespace mixed_palletizing::packing
