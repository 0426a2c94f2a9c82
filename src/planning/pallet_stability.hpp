// How safely a pallet stands.
#pragma once

#include <array>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::planning {

/// By weight when the weights of all placed boxes are known, else by volume [mm]; zeros on an empty pallet.
std::array<double, 3> centreOfGravity(const packing::PalletState& pallet, const packing::Order& order);

/// The smallest share of a base that lies on the floor or on tops of its height; 1 on an empty pallet.
double leastSupport(const packing::PalletState& pallet);

/// Distance [mm] in the plane from the centre of gravity to the nearest edge of the convex hull of the boxes on
/// the floor: negative when it lies outside, 0 on an empty pallet.
double gravityMargin(const packing::PalletState& pallet, const std::array<double, 3>& centre);

}  // namespace mixed_palletizing::planning
