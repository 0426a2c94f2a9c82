#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <mixed_palletizing/simulation/recipe.hpp>

#include "box_arrangements.hpp"
#include "box_looks.hpp"
#include "counter_random.hpp"
#include "draws.hpp"
#include "scene_view.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr int kSceneAttempts = 500;
constexpr int kCountAttempts = 50;  // before other numbers of groups are drawn
constexpr int kGroupAttempts = 100;

/// A scene that grows group by group.
class RecipeScene {
 public:
  RecipeScene(const Recipe& recipe, Draws& draws) : recipe_(recipe), draws_(draws), scene_(recipe.scene) {
    scene_.boxes.clear();
    scene_.objects.clear();
  }

  /// False when the draw came to nothing.
  bool draw(const std::vector<int>& group_counts) {
    if (!drawCamera()) return false;
    for (std::size_t i = 0; i < group_counts.size(); ++i) {
      for (int k = 0; k < group_counts[i]; ++k) {
        if (!drawGroup(recipe_.groups[i])) return false;
      }
    }
    return true;
  }

  const Scene& scene() const { return scene_; }

 private:
  bool drawCamera();
  bool drawGroup(const RecipeGroup& group);
  bool accepts(const SceneView& view, const std::vector<PlacedBox>& group) const;
  bool seenAsAsked() const;

  const Recipe& recipe_;
  Draws& draws_;
  Scene scene_;
  std::vector<Range> visibility_;  // by box of the scene
};

bool RecipeScene::drawCamera() {
  const RecipeView& view = recipe_.view;
  const double distance = draws_.in(view.distance_m);
  const double tilt = draws_.in(view.tilt_rad);
  const double azimuth = draws_.in(view.azimuth_rad);
  const Range& ring = view.target_offset_m;
  const double offset =
      std::sqrt(draws_.between(ring.min * ring.min, ring.max * ring.max));  // even over the area
  const double bearing = draws_.between(-M_PI, M_PI);
  const Eigen::Vector2d middle = scene_.has_marker ? scene_.marker.position_m : Eigen::Vector2d(0.0, 0.0);
  const Eigen::Vector3d target(middle.x() + offset * std::cos(bearing),
                               middle.y() + offset * std::sin(bearing), 0.0);
  const Eigen::Vector3d direction(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                                  std::cos(tilt));
  scene_.camera.world_from_camera = lookAt(target + distance * direction, target);
  if (!scene_.has_marker || !view.marker_in_sight) return true;
  return SceneView(scene_.camera, view.border_px_ratio).contains(paper(scene_.marker));
}

bool RecipeScene::accepts(const SceneView& view, const std::vector<PlacedBox>& group) const {
  for (const PlacedBox& placed : group) {
    if (placed.in_image && !view.contains(placed.box)) return false;
    for (const SceneBox& other : scene_.boxes) {
      if (geometry::distance(footprint(placed.box), footprint(other)) < recipe_.boxes.gap_m) return false;
    }
    if (!scene_.has_marker) continue;
    if (geometry::distance(footprint(placed.box), paper(scene_.marker)) < recipe_.boxes.gap_m) return false;
  }
  return !group.empty();
}

/// Later boxes may hide earlier ones, so all are looked at.
bool RecipeScene::seenAsAsked() const {
  if (scene_.has_marker && recipe_.view.marker_in_sight && !markerInSight(scene_)) return false;
  const SceneView image(scene_.camera, 0.0);
  for (std::size_t i = 0; i < scene_.boxes.size(); ++i) {
    const Range& asked = visibility_[i];
    if (asked.min <= 0.0 && asked.max >= 1.0) continue;
    if (!asked.contains(topVisibility(scene_, image, i))) return false;
  }
  return true;
}

bool RecipeScene::drawGroup(const RecipeGroup& group) {
  const SceneView view(scene_.camera, recipe_.view.border_px_ratio);
  const std::size_t before = scene_.boxes.size();
  for (int attempt = 0; attempt < kGroupAttempts; ++attempt) {
    const ProposedGroup proposed = proposeGroup(recipe_, group, scene_.camera, view, draws_);
    if (!accepts(view, proposed.boxes)) continue;
    for (const PlacedBox& placed : proposed.boxes) {
      scene_.boxes.push_back(placed.box);
      visibility_.push_back(placed.top_visibility);
    }
    if (seenAsAsked()) {
      scene_.objects.insert(scene_.objects.end(), proposed.objects.begin(), proposed.objects.end());
      return true;
    }
    scene_.boxes.resize(before);
    visibility_.resize(before);
  }
  return false;
}

void drawSensor(const RecipeSensor& sensor, Draws& draws, Scene& scene) {
  Noise& noise = scene.noise;
  if (sensor.depth_stddev_at_1m_m) noise.depth_stddev_at_1m_m = draws.in(*sensor.depth_stddev_at_1m_m);
  if (sensor.dropout_ratio) noise.dropout_ratio = draws.in(*sensor.dropout_ratio);
  if (sensor.flying_pixel_ratio) noise.flying_pixel_ratio = draws.in(*sensor.flying_pixel_ratio);
  if (!sensor.floor_rgb.empty()) scene.floor.rgb = draws.one(sensor.floor_rgb);
}

/// How many groups of each kind.
std::vector<int> drawCounts(const Recipe& recipe, Draws& draws) {
  std::vector<int> counts;
  for (const RecipeGroup& group : recipe.groups) counts.push_back(draws.in(group.count));
  return counts;
}

}  // namespace

Scene recipeScene(const Recipe& recipe, std::uint64_t seed, std::uint64_t index) {
  std::string text;
  for (const std::string& problem : problems(recipe)) text += "\n" + problem;
  if (!text.empty()) throw std::invalid_argument("recipeScene: the recipe is broken:" + text);
  Draws draws(mixBits(seed) ^ mixBits(~index));
  std::vector<int> counts;
  for (int attempt = 0; attempt < kSceneAttempts; ++attempt) {
    if (attempt % kCountAttempts == 0) counts = drawCounts(recipe, draws);
    RecipeScene drawn(recipe, draws);
    if (!drawn.draw(counts)) continue;
    Scene scene = drawn.scene();
    const int boxes = static_cast<int>(scene.boxes.size());
    if (boxes < recipe.boxes_total.min || boxes > recipe.boxes_total.max) {
      counts = drawCounts(recipe, draws);
      continue;
    }
    drawSensor(recipe.sensor, draws, scene);
    for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
      scene.boxes[i].name = "box_" + std::to_string(i + 1);
      paintBox(recipe.paint, draws, scene.boxes[i]);
      shapeBox(recipe.shape, draws, scene.boxes[i]);
    }
    if (problems(scene).empty())
      return scene;  // else a shape too large for its box, or one that meets another
  }
  throw std::runtime_error(
      "recipeScene: recipe '" + recipe.name + "', seed " + std::to_string(seed) + ", scene " +
      std::to_string(index) +
      ": no room for the boxes before the camera; fewer or smaller ones, or more distance, "
      "are needed");
}

std::uint64_t recipeNoiseSeed(std::uint64_t seed, std::uint64_t index) {
  return mixBits(mixBits(seed) + index);
}

}  // namespace mixed_palletizing::simulation
