#include "box_stack.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace mixed_palletizing::simulation {
namespace {

constexpr std::uint32_t kWood = 0xb59a6e;

/// Borders of the rows (or columns) of a layer: as many as the drawn sizes suggest, of different widths, in order.
std::vector<double> cuts(double length, const Range& size, Draws& draws) {
  const int parts = std::max(1, static_cast<int>(std::lround(length / draws.in(size))));
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = 0; i < parts; ++i) {
    weights.push_back(draws.in(size));
    sum += weights.back();
  }
  std::vector<double> borders{-0.5 * length};
  for (const double weight : weights) borders.push_back(borders.back() + length * weight / sum);
  return borders;
}

/// A layer of boxes over the whole footprint, in the axes of the stack.
std::vector<SceneBox> drawLayer(const Recipe& recipe, const RecipeGroup& group, const Eigen::Vector2d& length,
                                double base_z, Draws& draws) {
  const bool turned = draws.chance(0.5);
  const Range& along_x = turned ? recipe.boxes.size_y_m : recipe.boxes.size_x_m;
  const Range& along_y = turned ? recipe.boxes.size_x_m : recipe.boxes.size_y_m;
  const double height = draws.in(recipe.boxes.size_z_m);
  const double gap = draws.in(group.gap_m);
  std::vector<SceneBox> boxes;
  const std::vector<double> columns = cuts(length.x(), along_x, draws);
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    const std::vector<double> rows = cuts(length.y(), along_y, draws);
    for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
      SceneBox box;
      box.size_m = {columns[i + 1] - columns[i] - gap, rows[j + 1] - rows[j] - gap, height};
      box.position_m = {0.5 * (columns[i] + columns[i + 1]), 0.5 * (rows[j] + rows[j + 1])};
      box.base_z_m = base_z;
      boxes.push_back(box);
    }
  }
  return boxes;
}

/// A closed slab: nothing looks between its boards.
SceneObject pallet(const SceneBox& place, const Eigen::Vector2d& length, double height) {
  SceneObject object;
  object.name = "pallet";
  object.kind = "cuboid";
  object.mesh = std::make_shared<TriangleMesh>(cuboidMesh({length.x(), length.y(), height}));
  object.world_from_object =
      geometry::poseFromYaw({place.position_m.x(), place.position_m.y(), 0.0}, place.yaw_rad);
  object.rgb = kWood;
  return object;
}

}  // namespace

ProposedGroup proposeStack(const Recipe& recipe, const RecipeGroup& group, const SceneBox& place,
                           Draws& draws) {
  const double length_x = draws.in(group.length_x_m);
  const Eigen::Vector2d length(length_x, draws.in(group.length_y_m));
  const int layers = draws.in(group.layers);
  const double fill = draws.in(group.fill_ratio);
  ProposedGroup stack;
  const double pallet_height = draws.in(group.pallet_height_m);
  if (pallet_height > 0.0) stack.objects.push_back(pallet(place, length, pallet_height));
  double base_z = pallet_height;
  for (int layer = 0; layer < layers; ++layer) {
    const bool is_top = layer + 1 == layers;
    const std::vector<SceneBox> boxes = drawLayer(recipe, group, length, base_z, draws);
    for (SceneBox box : boxes) {
      if (is_top && !draws.chance(fill)) continue;
      if (is_top) box.size_m.z() += draws.in(group.height_step_m);
      box.position_m = place.position_m + Eigen::Rotation2Dd(place.yaw_rad) * box.position_m;
      box.yaw_rad = place.yaw_rad;
      stack.boxes.push_back({box, group.top_visibility});
    }
    base_z += boxes.front().size_m.z();
  }
  return stack;
}

}  // namespace mixed_palletizing::simulation
