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

/// The type of every item: the arrival, or the expanded items when the instance has none. Results name items
/// by their index in this list.
std::vector<int> itemTypes(const Instance& instance);

/// The items (indices in itemTypes()) in the order they arrive: as they are listed when the instance has an
/// arrival, shuffled by `seed` when it has none.
std::vector<int> arrivalItems(const Instance& instance, std::uint64_t seed);

/// The types of arrivalItems().
std::vector<int> arrivalOf(const Instance& instance, std::uint64_t seed);

}  // namespace mixed_palletizing::instances
