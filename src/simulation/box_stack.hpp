// Layers of boxes as on a pallet.
#pragma once

#include <mixed_palletizing/simulation/recipe.hpp>

#include "box_arrangements.hpp"
#include "draws.hpp"

namespace mixed_palletizing::simulation {

/// A stack at the place of a box, on a pallet if the group has one: in each layer boxes of one height in rows and columns; only some of the places of
/// the top layer are taken, by boxes of several heights.
ProposedGroup proposeStack(const Recipe& recipe, const RecipeGroup& group, const SceneBox& place,
                           Draws& draws);

}  // namespace mixed_palletizing::simulation
