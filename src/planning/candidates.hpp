// The distinct items that can be picked now.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <mixed_palletizing/planning/next_pick.hpp>

namespace mixed_palletizing::planning {

/// What is wrong with a list of available items: an index that is no type, or more items of a type than
/// remain. Empty when nothing is.
std::string availableProblem(const std::vector<int>& available, const std::vector<int>& remaining);

/// Why an item of this type fits nowhere on the pallet, in words and numbers.
std::string whyNowhere(const packing::PalletState& pallet, const packing::ItemType& type, int type_index);

/// `remaining` less one item of `type`, as a list of types.
std::vector<int> restItems(std::vector<int> remaining, int type);

/// The situation with the forecast's numbers, rounded, taken for real ones.
Situation withExpected(const Situation& situation);

/// Index of the first available item of the same type; `i` when there is none before it.
std::size_t firstOfType(const std::vector<int>& available, std::size_t i);

}  // namespace mixed_palletizing::planning
