// Boxes on a pallet, judged without the packing core.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::torture {

/// What the independent check of results finds in boxes of an order that stand so; empty when nothing.
std::string unsound(const packing::Order& order, const std::vector<packing::Placement>& placements);

}  // namespace mixed_palletizing::torture
