// Instances: an order with, optionally, its sequence of arrival and a known perfect packing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::instances {

struct Instance {
  std::string name;
  packing::Order order;
  std::vector<int> arrival;  ///< item types in the order they arrive; empty = drawn from a seed
  int n_pick = 3;            ///< boxes that can be picked at a time
  std::vector<packing::Placement> perfect_packing;  ///< of every item, in loading order; empty = not known
};

/// Every broken rule of an instance as one line; empty when it is sound.
std::vector<std::string> problems(const Instance& instance);

/// Every item's type in a fixed sequence: the items of type 0, then of type 1, ...
std::vector<int> expandedItems(const packing::Order& order);

/// The instance's arrival, or the expanded items shuffled by `seed` when it has none.
std::vector<int> arrivalOf(const Instance& instance, std::uint64_t seed);

}  // namespace mixed_palletizing::instances
