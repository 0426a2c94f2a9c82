// What is known of the items still to come.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>

namespace mixed_palletizing::planning {

enum class Knowledge {
  kSet,       ///< how many of each type, never their order
  kForecast,  ///< so many are sure to come, and how many more of each type are expected
  kTypes,     ///< the types only: as many of each as fill the free volume in equal shares are expected
};

/// "set", "forecast" or "types".
const char* toString(Knowledge knowledge);

/// What an order's counts mean.
struct OrderKnowledge {
  Knowledge kind = Knowledge::kSet;
  std::vector<double> expected;  ///< kForecast: per type, beside the order's counts
};

/// Every broken rule of an order of which so much is known, as one line. Only with kSet an item is needed;
/// with kTypes all counts must be 0.
std::vector<std::string> problems(const packing::Order& order, const OrderKnowledge& knowledge);

/// Per type: how many fill an equal share of the volume that is left on the pallet when the `available` items
/// are on it.
std::vector<double> equalShares(const packing::PalletState& pallet,
                                const std::vector<packing::ItemType>& types,
                                const std::vector<int>& available);

/// The situation of a decision. `taken`: items of each type placed or discarded so far. With kSet the available
/// items are among the order's; with the others an available item that was not sure to come is one of the
/// expected, or one more.
Situation situationOf(const packing::PalletState& pallet, const packing::Order& order,
                      const OrderKnowledge& knowledge, const std::vector<int>& taken,
                      std::vector<int> available);

/// What a decision in this situation takes for granted, in words and numbers.
std::string assumptionOf(const Situation& situation, Knowledge knowledge);

}  // namespace mixed_palletizing::planning
