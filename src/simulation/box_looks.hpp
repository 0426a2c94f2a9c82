// Colours, labels and bands of random boxes, and how they depart from cuboids.
#pragma once

#include <mixed_palletizing/simulation/recipe.hpp>

#include "draws.hpp"

namespace mixed_palletizing::simulation {

void paintBox(const RecipePaint& paint, Draws& draws, SceneBox& box);

void shapeBox(const RecipeShape& shape, Draws& draws, SceneBox& box);

}  // namespace mixed_palletizing::simulation
