// Beam search over blocks: the strongest search for orders with full support and no gap.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

/// Which space is filled first.
enum class SpaceOrder {
  kNearest,  ///< nearest to a corner of the pallet, height and horizontal distances alike
  kLowest,   ///< lowest, then nearest to a corner
};

struct BlockSearchOptions {
  std::size_t max_blocks = 10000;
};

/// Searches in rounds of growing width, so that it can be ended and taken up again at any time.
class BlockSearch {
 public:
  /// `counts[i]` items of `types[i]`; gap 0 and full support.
  BlockSearch(const Vec3& pallet, const std::vector<ItemType>& types, const std::vector<int>& counts,
              const BlockSearchOptions& options);
  ~BlockSearch();

  /// One round of the beam search with `width` states a level; ends early when everything is packed or `stop`
  /// says so, which is asked before every completion of a state but the very first. True when the round was
  /// played to its end.
  bool run(SpaceOrder order, std::size_t width, const StopCallback& stop);

  std::int64_t bestVolume() const;  ///< [mm^3]
  std::int64_t lastVolume() const;  ///< of the best packing of the last round alone [mm^3]
  bool complete() const;            ///< everything is packed

  /// The best packing so far in an order in which it can be loaded.
  std::vector<Placement> bestPlacements() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mixed_palletizing::packing
