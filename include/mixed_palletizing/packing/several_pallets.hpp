// Packing of an order onto as many pallets as it needs.
#pragma once

#include <functional>
#include <vector>

#include <mixed_palletizing/packing/order_packing.hpp>

namespace mixed_palletizing::packing {

/// Makes the callback that ends the search for one pallet; `share` of the order's whole budget is this
/// pallet's, (0, 1]. May return an empty callback for the methods that end by themselves.
using BudgetCallback = std::function<StopCallback(double share)>;

struct SeveralPallets {
  std::vector<OrderPacking> pallets;  ///< item indices are those in the given items; `unpacked` is empty
  std::vector<int> unpacked;          ///< indices in the given items, ascending
};

/// No fewer pallets can hold the items: by volume and, where the rules limit it, by weight. At least 1.
int leastPallets(const Order& order, const std::vector<int>& items);

/// Fills pallet after pallet with packOrder(), each with what the ones before left over, until everything is
/// packed, `max_pallets` are used (0 = as many as are needed) or nothing fits any more. Errors as packOrder(),
/// and std::invalid_argument for a negative `max_pallets`.
SeveralPallets packPallets(const Order& order, const std::vector<int>& items, const PackOptions& options,
                           int max_pallets, const BudgetCallback& budget, const PackReport& report = {});

}  // namespace mixed_palletizing::packing
