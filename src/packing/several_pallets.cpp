#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include <mixed_palletizing/packing/several_pallets.hpp>

namespace mixed_palletizing::packing {

namespace {

constexpr double kRounding = 1e-9;  ///< of a sum of weights, relative

std::vector<int> typesOf(const std::vector<int>& items, const std::vector<int>& chosen) {
  std::vector<int> types;
  types.reserve(chosen.size());
  for (const int item : chosen) types.push_back(items[static_cast<std::size_t>(item)]);
  return types;
}

}  // namespace

int leastPallets(const Order& order, const std::vector<int>& items) {
  std::int64_t packed = 0;
  double weight = 0.0;
  for (const int index : items) {
    const ItemType& type = order.types.at(static_cast<std::size_t>(index));
    packed += volume(type.size);
    weight += type.weight_kg;
  }
  const std::int64_t pallet = volume(order.rules.room().size());
  int least = static_cast<int>(std::max<std::int64_t>(1, (packed + pallet - 1) / pallet));
  if (order.rules.max_weight_kg > 0.0) {
    least =
        std::max(least, static_cast<int>(std::ceil(weight / order.rules.max_weight_kg * (1.0 - kRounding))));
  }
  return least;
}

SeveralPallets packPallets(const Order& order, const std::vector<int>& items, const PackOptions& options,
                           int max_pallets, const BudgetCallback& budget, const PackReport& report) {
  if (max_pallets < 0) {
    throw std::invalid_argument("packPallets: max_pallets: " + std::to_string(max_pallets) + " is negative");
  }
  SeveralPallets result;
  std::vector<int> left(items.size());
  std::iota(left.begin(), left.end(), 0);
  double share_left = 1.0;
  do {
    const std::vector<int> types = typesOf(items, left);
    int expected = leastPallets(order, types);
    if (max_pallets > 0) expected = std::min(expected, max_pallets - static_cast<int>(result.pallets.size()));
    const double share = share_left / expected;
    // A pallet beyond the least number finds little budget left; it still gets what one of them had.
    share_left = std::max(share_left - share, share / 2.0);
    OrderPacking pallet = packOrder(order, types, options, budget ? budget(share) : StopCallback{}, report);
    if (pallet.packed.empty() && !result.pallets.empty()) break;
    std::vector<int> rest;
    for (const int item : pallet.unpacked) rest.push_back(left[static_cast<std::size_t>(item)]);
    for (PackedItem& packed : pallet.packed) packed.item = left[static_cast<std::size_t>(packed.item)];
    pallet.unpacked.clear();
    const bool stuck = pallet.packed.empty();
    result.pallets.push_back(std::move(pallet));
    left = std::move(rest);
    if (stuck) break;
  } while (!left.empty() && (max_pallets == 0 || static_cast<int>(result.pallets.size()) < max_pallets));
  result.unpacked = std::move(left);
  return result;
}

}  // namespace mixed_palletizing::packing
