// Generated orders of many kinds, on which the policy of the planner is tuned.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/planning/policy_tuning.hpp>

namespace mixed_palletizing::adapters {

/// "blocks", "columns": the thesis' boxes. "continuous": blocks of any height. "yaw", "any": blocks that may be
/// turned about the vertical or any side. "spread": blocks with sides drawn anew within 10 mm, turned about the
/// vertical. "cuts": boxes of any size, turned about the vertical.
const std::vector<std::string>& tuningKinds();

/// Which orders: of every kind and height `count` in an iteration.
struct TuningMixture {
  std::vector<std::string> kinds = tuningKinds();
  std::vector<int> heights{600, 800, 1200};  ///< of the pallets [mm]
  int count = 6;
  std::uint64_t seed = 1;
};

/// Every broken rule as a line.
std::vector<std::string> problems(const TuningMixture& mixture);

/// Orders of an iteration (0, 1, ..., or -1 for orders that no other iteration has). Throws std::invalid_argument with
/// the first of problems(mixture).
std::vector<planning::TuningOrder> tuningOrders(const TuningMixture& mixture, int iteration);

}  // namespace mixed_palletizing::adapters
