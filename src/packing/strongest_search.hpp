// The strongest search for an order on one pallet: what the method "best" runs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <mixed_palletizing/packing/order_packing.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>

#include "block_search.hpp"

namespace mixed_palletizing::packing {

/// Rounds of the genetic search with a growing population and, where no gap is asked for,
/// of the block search with a growing width.
class StrongestSearch {
 public:
  /// Keeps references to all arguments. The items' indices and sizes must be good.
  StrongestSearch(const Order& order, const std::vector<int>& items, const PackOptions& options,
                  const StopCallback& stop);

  /// Searches until everything is packed or `stop` says so.
  void run(const PackReport& report);

  const std::vector<Placement>& placements() const {
    return placements_;
  }  ///< the best so far, in loading order
  double utilization() const;

 private:
  bool blocksServe() const;
  void geneticRound(int round);
  void blockRound(SpaceOrder space_order, std::size_t width);
  SequenceResult keepRules(const std::vector<Placement>& placements) const;
  void take(std::vector<Placement> placements, std::int64_t packed);

  const Order& order_;
  const std::vector<int>& items_;
  const PackOptions& options_;
  const StopCallback& stop_;
  PalletState pallet_;
  std::optional<BlockSearch> blocks_;  ///< made when it is first needed: that takes time
  std::vector<Placement> placements_;
  std::int64_t volume_ = 0;
  bool complete_ = false;
};

}  // namespace mixed_palletizing::packing
