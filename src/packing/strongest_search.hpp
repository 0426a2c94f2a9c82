// The strongest search for an order on one pallet: what the method "best" runs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <mixed_palletizing/packing/order_packing.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>

#include "block_search.hpp"

namespace mixed_palletizing::packing {

/// Rounds of the genetic search with a growing population and, where no gap is asked for, of the block search with a
/// growing width; where blocks do not serve, of the random-key search. What has found less has its turn less often.
/// With two threads the second one plays every other order of spaces of the block search, so that the result does
/// not depend on their speed unless time ends it.
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
  bool goesOn() const { return !complete_ && !stop_(); }
  void geneticRound(int round);
  void randomKeyRound(int round);
  void blockRounds(int round, std::size_t width);
  void playBlocks(std::size_t player, std::size_t space_order, std::size_t width);
  void takeBlocks(const BlockSearch& search);
  SequenceResult keepRules(const std::vector<Placement>& placements) const;
  void take(const SequenceResult& found);

  const Order& order_;
  const std::vector<int>& items_;
  const PackOptions& options_;
  StopCallback stop_;
  StopCallback second_stop_;  ///< of the second thread
  PalletState pallet_;
  /// Made when they are first needed: that takes time. The second one is that of the second thread.
  std::array<std::optional<BlockSearch>, 2> blocks_;
  std::vector<Placement> placements_;
  std::int64_t volume_ = 0;
  std::array<std::int64_t, 2> order_volumes_{};  ///< of the last block round in each order of spaces
  bool genetic_lags_ = false;                    ///< the genetic search found less than the blocks
  bool complete_ = false;
};

}  // namespace mixed_palletizing::packing
