// Empty maximal spaces in three dimensions.
#pragma once

#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

/// `spaces` are all maximal empty cuboids; afterwards they are those without `box`. The ones that went are
/// appended to `removed`. The result is sorted as PalletState::spaces().
void cutOut(std::vector<Space>& spaces, const Space& box, std::vector<Space>& removed);

/// Takes the last cutOut() back: `removed` are the spaces that went.
void restore(std::vector<Space>& spaces, const std::vector<Space>& removed);

}  // namespace mixed_palletizing::packing
