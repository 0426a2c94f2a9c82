// Sides of tops that nothing shows: how far away they may be, from what the camera would else have seen.
#pragma once

#include <vector>

#include "level_box.hpp"

namespace mixed_palletizing::detection {

/// Moves every side without outline of every top to the middle of the range in which it may lie, and gives it that
/// range's standard deviation, and 15 mm for what may have passed for the top. The range ends where the camera looks
/// past the level, and at the footprint of a higher box; a parallel side of a higher box that hides the rest is taken
/// for the place where the two touch.
void completeHidden(const LevelContext& context, std::vector<FittedTop>& tops);

}  // namespace mixed_palletizing::detection
