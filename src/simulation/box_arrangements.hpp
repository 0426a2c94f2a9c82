// Groups of boxes in random arrangements.
#pragma once

#include <vector>

#include <mixed_palletizing/simulation/recipe.hpp>

#include "draws.hpp"
#include "scene_view.hpp"

namespace mixed_palletizing::simulation {

/// A box in front of the camera and what has to be seen of it.
struct PlacedBox {
  SceneBox box;
  Range top_visibility;
  bool in_image = true;  ///< all of it
};

/// What is placed together.
struct ProposedGroup {
  std::vector<PlacedBox> boxes;
  std::vector<SceneObject> objects;  ///< what they stand on
};

/// Boxes of one group somewhere in the view, unpainted; none when the draw came to nothing. Within the group they
/// do not overlap; whether they collide with other boxes or can be seen as asked is not looked at.
ProposedGroup proposeGroup(const Recipe& recipe, const RecipeGroup& group, const Camera& camera,
                           const SceneView& view, Draws& draws);

}  // namespace mixed_palletizing::simulation
