#include "box_arrangements.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "box_stack.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr double kOutsideRatio =
    0.15;  // centres of cut boxes lie up to this share of the image beyond its border
constexpr int kNeighbourAttempts = 20;
constexpr Range kWhole{1.0, 1.0};  // the top of the box that hides another

Eigen::Vector3d drawSize(const RecipeBoxes& boxes, Draws& draws) {
  const double x = draws.in(boxes.size_x_m);
  const double y = draws.in(boxes.size_y_m);
  const double z = draws.in(boxes.size_z_m);
  return {x, y, z};
}

std::optional<SceneBox> drawBox(const RecipeBoxes& boxes, const SceneView& view, double beyond_ratio,
                                Draws& draws) {
  SceneBox box;
  box.size_m = drawSize(boxes, draws);
  box.yaw_rad = draws.in(boxes.yaw_rad);
  const std::optional<Eigen::Vector2d> place = view.floorPlace(draws, beyond_ratio);
  if (!place && !(boxes.x_m && boxes.y_m)) return std::nullopt;
  box.position_m = place.value_or(Eigen::Vector2d::Zero());
  if (boxes.x_m) box.position_m.x() = draws.in(*boxes.x_m);
  if (boxes.y_m) box.position_m.y() = draws.in(*boxes.y_m);
  return box;
}

/// `neighbour` moved so that it stands face to face with `box` on one of its four sides.
void putBeside(const SceneBox& box, const RecipeGroup& group, Draws& draws, SceneBox& neighbour) {
  const int side = draws.in(CountRange{0, 3});
  const int normal = side / 2;  // axis of the box that the face looks along
  const double sign = side % 2 == 0 ? -1.0 : 1.0;
  const double away = 0.5 * (box.size_m[normal] + neighbour.size_m[normal]) + draws.in(group.gap_m);
  const double length = box.size_m[1 - normal];
  const double other = neighbour.size_m[1 - normal];
  const double contact = draws.in(group.contact_ratio) * std::min(length, other);
  const double slack = 0.5 * (length + other) - contact;  // how far along the face gives this much contact
  Eigen::Vector2d shift;
  shift[normal] = sign * away;
  shift[1 - normal] = draws.chance(0.5) ? slack : -slack;
  neighbour.yaw_rad = box.yaw_rad;
  neighbour.position_m = box.position_m + Eigen::Rotation2Dd(box.yaw_rad) * shift;
}

/// Height of a neighbour, a step above or below the first box's, within the range of heights if one of both is.
double steppedHeight(const RecipeGroup& group, const Range& heights, double first_height, Draws& draws) {
  const double step = draws.in(group.height_step_m) * (draws.chance(0.5) ? 1.0 : -1.0);
  if (heights.contains(first_height + step)) return first_height + step;
  return heights.contains(first_height - step) ? first_height - step : first_height + std::abs(step);
}

std::vector<PlacedBox> proposeTouching(const Recipe& recipe, const RecipeGroup& group, const SceneView& view,
                                       Draws& draws) {
  const std::optional<SceneBox> first = drawBox(recipe.boxes, view, 0.0, draws);
  if (!first) return {};
  std::vector<PlacedBox> boxes{{*first, group.top_visibility}};
  const int count = draws.in(group.boxes);
  while (static_cast<int>(boxes.size()) < count) {
    bool placed = false;
    for (int attempt = 0; attempt < kNeighbourAttempts && !placed; ++attempt) {
      SceneBox box;
      box.size_m = drawSize(recipe.boxes, draws);
      box.size_m.z() = steppedHeight(group, recipe.boxes.size_z_m, first->size_m.z(), draws);
      putBeside(draws.one(boxes).box, group, draws, box);
      placed = std::none_of(boxes.begin(), boxes.end(), [&](const PlacedBox& other) {
        return geometry::distance(footprint(box), footprint(other.box)) == 0.0;
      });
      if (placed) boxes.push_back({box, group.top_visibility});
    }
    if (!placed) return {};
  }
  return boxes;
}

/// A box, and a taller one on the camera's side of it.
std::vector<PlacedBox> proposeHidden(const Recipe& recipe, const RecipeGroup& group, const Camera& camera,
                                     const SceneView& view, Draws& draws) {
  const std::optional<SceneBox> low = drawBox(recipe.boxes, view, 0.0, draws);
  if (!low) return {};
  SceneBox tall;
  tall.size_m = drawSize(recipe.boxes, draws);
  tall.size_m.z() = low->size_m.z() + draws.in(group.height_step_m);
  tall.yaw_rad = draws.in(recipe.boxes.yaw_rad);
  const Eigen::Vector2d to_camera = camera.world_from_camera.translation().head<2>() - low->position_m;
  const double bearing = std::atan2(to_camera.y(), to_camera.x()) + draws.in(group.bearing_rad);
  const Eigen::Vector2d direction(std::cos(bearing), std::sin(bearing));
  const double gap = draws.in(group.gap_m);
  // Moved away until the gap is reached: the distance of two rectangles grows along the way once they are apart.
  double near = 0.0;
  double far = low->size_m.head<2>().norm() + tall.size_m.head<2>().norm() + gap;
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (near + far);
    tall.position_m = low->position_m + middle * direction;
    (geometry::distance(footprint(*low), footprint(tall)) > gap ? far : near) = middle;
  }
  tall.position_m = low->position_m + far * direction;
  return {{*low, group.top_visibility}, {tall, kWhole}};
}

}  // namespace

ProposedGroup proposeGroup(const Recipe& recipe, const RecipeGroup& group, const Camera& camera,
                           const SceneView& view, Draws& draws) {
  if (group.arrangement == Arrangement::kTouching) return {proposeTouching(recipe, group, view, draws), {}};
  if (group.arrangement == Arrangement::kHidden) {
    return {proposeHidden(recipe, group, camera, view, draws), {}};
  }
  const bool is_cut = group.arrangement == Arrangement::kCut;
  const std::optional<SceneBox> box = drawBox(recipe.boxes, view, is_cut ? kOutsideRatio : 0.0, draws);
  if (!box) return {};
  if (group.arrangement == Arrangement::kStack) return proposeStack(recipe, group, *box, draws);
  return {{{*box, group.top_visibility, !is_cut}}, {}};
}

}  // namespace mixed_palletizing::simulation
