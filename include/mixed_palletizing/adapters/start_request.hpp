// The request that starts a pallet for an order.
#pragma once

#include <string>

#include <mixed_palletizing/StartPallet.h>
#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::adapters {

/// Everything that the order says: size [m], lines, gap, support.
StartPalletRequest startRequest(const std::string& pallet_id, const packing::Order& order);

}  // namespace mixed_palletizing::adapters
