#include "block_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "level_spaces.hpp"
#include "maximal_rectangles.hpp"

namespace mixed_palletizing::packing {

namespace {

std::int64_t surface(const Vec3& v) {
  const std::int64_t x = v.x;
  return 2 * (x * v.y + x * v.z + static_cast<std::int64_t>(v.y) * v.z);
}

void sortOrientations(BlockCatalog& catalog) {
  std::vector<std::pair<Vec3, std::size_t>> sizes;
  for (std::size_t type = 0; type < catalog.orientations.size(); ++type) {
    for (const Vec3& size : catalog.orientations[type]) sizes.emplace_back(size, type);
  }
  std::stable_sort(sizes.begin(), sizes.end(),
                   [](const auto& a, const auto& b) { return volume(a.first) < volume(b.first); });
  for (const auto& [size, type] : sizes) catalog.orientations_by_volume.emplace_back(PackedSize(size), type);
}

}  // namespace

BlockCatalog makeCatalog(const Vec3& pallet, const std::vector<ItemType>& types,
                         const std::vector<int>& counts, std::size_t max_blocks, double items_exponent) {
  BlockCatalog catalog;
  catalog.pallet = pallet;
  for (const ItemType& type : types) catalog.orientations.push_back(orientations(type));
  sortOrientations(catalog);
  catalog.blocks = makeBlocks(types, counts, pallet, max_blocks);
  for (const Block& block : catalog.blocks) {
    const double value = static_cast<double>(volume(block.size)) * std::pow(block.items, -items_exponent);
    catalog.ranked.push_back({block.size, static_cast<std::uint32_t>(catalog.ranked.size()), value,
                              1.0 / static_cast<double>(surface(block.size))});
  }
  std::stable_sort(catalog.ranked.begin(), catalog.ranked.end(),
                   [](const RankedBlock& a, const RankedBlock& b) { return a.value > b.value; });
  catalog.needs.assign(types.size(), std::vector<std::uint16_t>(catalog.ranked.size(), 0));
  for (std::size_t rank = 0; rank < catalog.ranked.size(); ++rank) {
    const Block& block = catalog.blocks[catalog.ranked[rank].index];
    catalog.sizes.emplace_back(block.size);
    for (const TypeCount& need : block.needs) {
      catalog.needs[static_cast<std::size_t>(need.type)][rank] =
          static_cast<std::uint16_t>(std::min(need.count, BlockCatalog::kManyItems));
    }
  }
  return catalog;
}

BlockState::BlockState(const BlockCatalog& catalog, const std::vector<int>& counts) : remaining_(counts) {
  spaces_.push_back({{0, 0, 0}, catalog.pallet});
  for (std::size_t rank = 0; rank < catalog.ranked.size(); ++rank) {
    ranks_.push_back(static_cast<std::uint32_t>(rank));
  }
  collectSmallest(catalog);
}

bool BlockState::isUseful(const Space& space) const {
  const PackedSize room(space.size());
  return std::any_of(smallest_.begin(), smallest_.end(),
                     [&](const PackedSize& size) { return size.fitsInto(room); });
}

void BlockState::place(const BlockCatalog& catalog, const BlockStep& step) {
  const Block& block = catalog.blocks[step.block];
  const Placement body{0, step.origin, block.size};
  const int top = step.origin.z + block.size.z;
  LevelSpaces levels(spaces_, catalog.pallet.z);
  levels.edit(step.origin.z, [&](std::vector<Rect>& rects) { cutOut(rects, footprintOf(body)); });
  if (top < catalog.pallet.z) {
    levels.edit(top, [&](std::vector<Rect>& rects) { addRect(rects, footprintOf(body)); });
  }
  standing_.push_back({step.origin, {step.origin.x + block.size.x, step.origin.y + block.size.y, top}});
  steps_.push_back(step);
  packed_volume_ += volume(block.size);
  bool type_ends = false;
  for (const TypeCount& need : block.needs) {
    const std::size_t type = static_cast<std::size_t>(need.type);
    remaining_[type] -= need.count;
    type_ends = type_ends || remaining_[type] == 0;
    if (remaining_[type] >= BlockCatalog::kManyItems) continue;
    const std::vector<std::uint16_t>& needs = catalog.needs[type];
    const std::uint16_t left = static_cast<std::uint16_t>(remaining_[type]);
    ranks_.erase(
        std::remove_if(ranks_.begin(), ranks_.end(), [&](std::uint32_t r) { return needs[r] > left; }),
        ranks_.end());
  }
  if (type_ends) collectSmallest(catalog);
}

void BlockState::collectSmallest(const BlockCatalog& catalog) {
  smallest_.clear();
  for (const auto& [size, type] : catalog.orientations_by_volume) {
    if (remaining_[type] == 0) continue;
    const bool holds_another =
        std::any_of(smallest_.begin(), smallest_.end(),
                    [&, s = size](const PackedSize& other) { return other.fitsInto(s); });
    if (!holds_another) smallest_.push_back(size);
  }
}

std::uint64_t BlockState::fingerprint() const {
  std::uint64_t hash = 1469598103934665603ULL;  // FNV-1a, by words
  const auto mix = [&hash](int value) {
    hash = (hash ^ static_cast<std::uint64_t>(value)) * 1099511628211ULL;
    hash ^= hash >> 29U;
  };
  for (const Space& space : spaces_) {
    mix(space.min.x);
    mix(space.min.y);
    mix(space.min.z);
    mix(space.max.x);
    mix(space.max.y);
  }
  for (const int count : remaining_) mix(count);
  return hash;
}

}  // namespace mixed_palletizing::packing
