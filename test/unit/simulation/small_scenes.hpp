// Small images and random scenes for the tests of the simulation.
#pragma once

#include <cstdint>

#include <mixed_palletizing/geometry/organized_cloud.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace mixed_palletizing::simulation {

/// Random scene without noise, seen in `width` x (5/8 width) pixels.
inline Scene smallScene(std::uint64_t seed, int width = 320) {
  Recipe recipe;
  recipe.scene.camera.width_px = width;
  recipe.scene.camera.height_px = width * 5 / 8;
  recipe.groups.front().count.min = 3;
  return recipeScene(recipe, seed, 0);
}

/// Floor alone, seen from straight above.
inline Scene bareFloor(double height_m, int width = 320) {
  Scene scene;
  scene.has_marker = false;
  scene.floor.size_x_m = scene.floor.size_y_m = 20.0;
  scene.camera.width_px = width;
  scene.camera.height_px = width * 5 / 8;
  scene.camera.world_from_camera = lookAt({0, 0, height_m}, {0, 0, 0});
  return scene;
}

inline std::size_t pixelIndex(const Scene& scene, int row, int col) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(scene.camera.width_px) +
         static_cast<std::size_t>(col);
}

/// A point of the cloud in the world.
inline Eigen::Vector3d worldPoint(const Scene& scene, const geometry::ColoredPoint& point) {
  return scene.camera.world_from_camera * Eigen::Vector3d(point.x, point.y, point.z);
}

/// Rays along an edge may fall to either side in single precision: this share of all pixels may differ.
constexpr double kEdgeRatio = 0.001;

}  // namespace mixed_palletizing::simulation
