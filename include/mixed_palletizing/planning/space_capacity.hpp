// How many items of each type a free room holds; remembered, as the same rooms come again and again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::planning {

/// Not thread safe.
class SpaceCapacity {
 public:
  /// `sizes[t]`: the sizes in which items of type t may stand [mm].
  explicit SpaceCapacity(const std::vector<std::vector<packing::Vec3>>& sizes);

  /// For a room [mm]: first for every type how many of its items fit on the base side by side, all turned
  /// alike, then for every type how many with as many layers as the height allows. Valid until the next call.
  const int* of(const packing::Vec3& room);

  std::size_t typeCount() const { return first_size_.size() - 1; }

 private:
  std::size_t find(std::uint64_t key) const;
  void grow();
  void fill(const packing::Vec3& room, int* row) const;

  std::vector<packing::Vec3> sizes_;       ///< of all types, one after the other
  std::vector<std::size_t> first_size_;    ///< of each type, and the end
  std::vector<std::uint64_t> keys_;        ///< open addressing, 0 = free
  std::vector<std::uint32_t> row_of_key_;  ///< parallel to keys_
  std::vector<int> rows_;                  ///< 2 * typeCount() numbers each
  std::size_t row_count_ = 0;
};

}  // namespace mixed_palletizing::planning
