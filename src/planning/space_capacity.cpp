#include <algorithm>

#include <mixed_palletizing/planning/space_capacity.hpp>

namespace mixed_palletizing::planning {
namespace {

constexpr std::size_t kFirstSlots = 1024;          ///< a power of two, as all later numbers of slots
constexpr std::size_t kMostNumbers = 8 * 1 << 20;  ///< remembered before everything is forgotten: 32 MiB

/// Never 0: every side is positive. A side, overhangs included, fits in 21 bits.
std::uint64_t keyOf(const packing::Vec3& room) {
  return static_cast<std::uint64_t>(room.x) << 42U | static_cast<std::uint64_t>(room.y) << 21U |
         static_cast<std::uint64_t>(room.z);
}

/// Finalizer of splitmix64 (Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

}  // namespace

SpaceCapacity::SpaceCapacity(const std::vector<std::vector<packing::Vec3>>& sizes)
    : keys_(kFirstSlots, 0), row_of_key_(kFirstSlots, 0) {
  for (const std::vector<packing::Vec3>& of_type : sizes) {
    first_size_.push_back(sizes_.size());
    sizes_.insert(sizes_.end(), of_type.begin(), of_type.end());
  }
  first_size_.push_back(sizes_.size());
}

const int* SpaceCapacity::of(const packing::Vec3& room) {
  const std::uint64_t key = keyOf(room);
  const std::size_t width = 2 * typeCount();
  std::size_t slot = find(key);
  if (keys_[slot] == key) return rows_.data() + row_of_key_[slot] * width;
  if (2 * (row_count_ + 1) > keys_.size() || (row_count_ + 1) * width > kMostNumbers) {
    grow();
    slot = find(key);
  }
  keys_[slot] = key;
  row_of_key_[slot] = static_cast<std::uint32_t>(row_count_++);
  rows_.resize(row_count_ * width);
  int* row = rows_.data() + (row_count_ - 1) * width;
  fill(room, row);
  return row;
}

std::size_t SpaceCapacity::find(std::uint64_t key) const {
  const std::size_t mask = keys_.size() - 1;
  std::size_t slot = mixed(key) & mask;
  while (keys_[slot] != 0 && keys_[slot] != key) slot = (slot + 1) & mask;
  return slot;
}

/// Twice the slots, or all forgotten when too much is remembered.
void SpaceCapacity::grow() {
  if (2 * (row_count_ + 1) * typeCount() > kMostNumbers) {
    std::fill(keys_.begin(), keys_.end(), 0);
    rows_.clear();
    row_count_ = 0;
    return;
  }
  const std::vector<std::uint64_t> keys = std::move(keys_);
  const std::vector<std::uint32_t> rows = std::move(row_of_key_);
  keys_.assign(2 * keys.size(), 0);
  row_of_key_.assign(2 * keys.size(), 0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == 0) continue;
    const std::size_t slot = find(keys[i]);
    keys_[slot] = keys[i];
    row_of_key_[slot] = rows[i];
  }
}

void SpaceCapacity::fill(const packing::Vec3& room, int* row) const {
  const std::size_t types = typeCount();
  for (std::size_t t = 0; t < types; ++t) {
    int most_places = 0;
    int most_items = 0;
    for (std::size_t i = first_size_[t]; i < first_size_[t + 1]; ++i) {
      const packing::Vec3& size = sizes_[i];
      if (size.x > room.x || size.y > room.y || size.z > room.z) continue;
      const int places = std::min((room.x / size.x) * (room.y / size.y), packing::kMaxItems);
      const std::int64_t items = static_cast<std::int64_t>(places) * (room.z / size.z);
      most_places = std::max(most_places, places);
      most_items = std::max(most_items, static_cast<int>(std::min<std::int64_t>(items, packing::kMaxItems)));
    }
    row[t] = most_places;
    row[types + t] = most_items;
  }
}

}  // namespace mixed_palletizing::planning
