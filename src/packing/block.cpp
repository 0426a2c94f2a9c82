// Source: general blocks of Fanslau and Bortfeldt (2010), here without holes: two blocks are joined along an axis when
// they agree in the other two, generation by generation.
#include "block.hpp"

#include <algorithm>
#include <array>
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

/// Spreads the bits of a number (the finalizer of splitmix64).
std::uint64_t spread(std::uint64_t v) {
  v = (v ^ (v >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  v = (v ^ (v >> 27U)) * 0x94d049bb133111ebULL;
  return v ^ (v >> 31U);
}

/// Of an item of a type; the sum over the items of a block stands for its content.
std::uint64_t itemKey(int type) { return spread(static_cast<std::uint64_t>(type) + 0x9e3779b97f4a7c15ULL); }

std::uint64_t blockKey(std::uint64_t content, const Vec3& size) {
  const std::uint64_t xy = (static_cast<std::uint64_t>(size.x) << 32U) | static_cast<std::uint64_t>(size.y);
  return content ^ spread(xy + spread(static_cast<std::uint64_t>(size.z)));
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
      for (const Vec3& size : orientations(types[t])) {
        const int type = static_cast<int>(t);
        if (isNew(itemKey(type), size)) add({size, {{type, 1}}}, itemKey(type));
      }
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

  /// Fits the pallet and was not seen before, neither taken nor refused.
  bool isNew(std::uint64_t content, const Vec3& size) {
    if (size.x > pallet_.x || size.y > pallet_.y || size.z > pallet_.z) return false;
    return known_.insert(blockKey(content, size)).second;
  }

  void join(std::size_t first, std::size_t second, int axis) {
    const Block& a = blocks_[first];
    const Block& b = blocks_[second];
    Vec3 size = a.size;
    side(size, axis) += side(b.size, axis);
    const std::uint64_t content = contents_[first] + contents_[second];
    if (isNew(content, size)) {
      add({size, sumOf(a.needs, b.needs), a.items + b.items, axis, first, second}, content);
    }
  }

  void add(Block block, std::uint64_t content) {
    for (const TypeCount& need : block.needs) {
      if (need.count > counts_[static_cast<std::size_t>(need.type)]) return;
    }
    for (int axis = 0; axis < 3; ++axis) {
      by_section_[static_cast<std::size_t>(axis)][sectionKey(block.size, axis)].push_back(blocks_.size());
    }
    blocks_.push_back(std::move(block));
    contents_.push_back(content);
  }

  const std::vector<int>& counts_;
  Vec3 pallet_;
  std::size_t max_blocks_;
  std::vector<Block> blocks_;
  std::vector<std::uint64_t> contents_;
  std::unordered_set<std::uint64_t> known_;
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
