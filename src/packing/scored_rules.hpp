// Placement rules that compare places by a score.
#pragma once

#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>

namespace mixed_palletizing::packing {

/// Share of the sides of a box, top and base apart, that touches other boxes or the planes of the pallet's
/// sides, [0, 1].
double touchingShare(const PalletState& state, const Placement& placement);

/// The placements at all four corners of the bases of the spaces that can hold one of `sizes`; only with
/// fullSupport().
std::vector<Placement> allCorners(const PalletState& state, const std::vector<Vec3>& sizes, int type);

/// The one that touches most; the first of equals.
const Placement* mostTouching(const PalletState& state, const std::vector<Placement>& placements);

/// The one that leaves the narrowest strip free beside it in a space it lies in, then the least strip in the
/// other direction; the first of equals.
const Placement* bestFitting(const PalletState& state, const std::vector<Placement>& placements);

}  // namespace mixed_palletizing::packing
