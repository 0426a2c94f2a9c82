// Recipes: what is drawn at random for a kind of scenes, and the scenes drawn by them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/simulation/recipe_parts.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

struct Recipe {
  std::string name;
  std::string about;  ///< what it shows, one line
  Scene scene;        ///< floor, marker, camera without its pose, noise; its boxes are not used
  RecipeView view;
  RecipeSensor sensor;
  RecipeBoxes boxes;
  RecipePaint paint;
  RecipeShape shape;
  std::vector<RecipeGroup> groups{RecipeGroup()};
  CountRange boxes_total{0, 1000};  ///< a scene with fewer or more is drawn again
};

/// Every broken rule as one line "key: what is wrong", keys as in a recipe file.
std::vector<std::string> problems(const Recipe& recipe);

/// Reads a recipe (docs/datasets.md); keys nobody knows, wrong types and values out of range are errors.
/// Throws std::invalid_argument with "file:line: key: what is wrong" lines, std::runtime_error when unreadable.
Recipe loadRecipe(const std::string& path);

/// Scene `index` of the recipe: the same for the same arguments. Throws std::invalid_argument with every line of
/// problems(recipe), std::runtime_error when no such scene was found (boxes too many or too large for the view).
Scene recipeScene(const Recipe& recipe, std::uint64_t seed, std::uint64_t index);

/// Seed of that scene's noise, for capture().
std::uint64_t recipeNoiseSeed(std::uint64_t seed, std::uint64_t index);

}  // namespace mixed_palletizing::simulation
