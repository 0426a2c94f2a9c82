// Recipes: every shipped one draws valid scenes, the same for the same numbers, that keep what they promise.
#include <algorithm>
#include <cmath>
#include <limits>

#include <mixed_palletizing/geometry/rectangle.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

#include "analytic_rays.hpp"
#include "temporary_folder.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr double kSinglePrecisionM = 1e-6;  // the corners of meshes are floats

std::string shipped(const std::string& name) {
  return std::string(MIXED_PALLETIZING_SOURCE_DIR "/config/recipes/") + name + ".yaml";
}

geometry::Rectangle footprint(const SceneBox& box) {
  return {box.position_m, box.yaw_rad, box.size_m.head<2>()};
}

/// Visibility of the tops in a small image.
std::vector<double> visibilityOf(Scene scene) {
  scene.camera.width_px = 480;
  scene.camera.height_px = 300;
  return capture(scene, 0).top_visibility;
}

void expectSame(const Scene& one, const Scene& two) {
  EXPECT_TRUE(one.camera.world_from_camera.matrix() == two.camera.world_from_camera.matrix());
  EXPECT_EQ(one.noise.depth_stddev_at_1m_m, two.noise.depth_stddev_at_1m_m);
  EXPECT_EQ(one.floor.rgb, two.floor.rgb);
  ASSERT_EQ(one.boxes.size(), two.boxes.size());
  for (std::size_t i = 0; i < one.boxes.size(); ++i) {
    EXPECT_EQ(one.boxes[i].size_m, two.boxes[i].size_m);
    EXPECT_EQ(one.boxes[i].position_m, two.boxes[i].position_m);
    EXPECT_EQ(one.boxes[i].yaw_rad, two.boxes[i].yaw_rad);
    EXPECT_EQ(one.boxes[i].rgb, two.boxes[i].rgb);
    EXPECT_EQ(one.boxes[i].labels.size(), two.boxes[i].labels.size());
  }
}

/// The shipped recipes of config/recipes, sorted.
std::vector<std::string> shippedNames() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(MIXED_PALLETIZING_SOURCE_DIR "/config/recipes")) {
    names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class ShippedRecipe : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedRecipe, DrawsValidScenesAgainAndAgain) {
  const Recipe recipe = loadRecipe(shipped(GetParam()));
  EXPECT_EQ(recipe.name, GetParam());
  EXPECT_FALSE(recipe.about.empty());
  for (std::uint64_t index = 0; index < 4; ++index) {
    SCOPED_TRACE("scene " + std::to_string(index));
    const Scene scene = recipeScene(recipe, 11, index);
    EXPECT_TRUE(problems(scene).empty());
    expectSame(scene, recipeScene(recipe, 11, index));
    EXPECT_GE(static_cast<int>(scene.boxes.size()), recipe.boxes_total.min);
    EXPECT_LE(static_cast<int>(scene.boxes.size()), recipe.boxes_total.max);
    EXPECT_NE(recipeNoiseSeed(11, index), recipeNoiseSeed(11, index + 1));
    if (!scene.has_marker) continue;
    const Eigen::Vector3d eye = scene.camera.world_from_camera.translation();
    for (const Eigen::Vector3d& corner : markerCorners(scene.marker)) {
      EXPECT_EQ(analytic::trace(scene, eye, corner - eye).object, 0);
      const Eigen::Vector2d image =
          Pinhole(scene.camera).project(scene.camera.world_from_camera.inverse() * corner);
      EXPECT_GE(image.minCoeff(), 0.0);
      EXPECT_LE(image.x(), scene.camera.width_px - 1);
      EXPECT_LE(image.y(), scene.camera.height_px - 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedRecipe, ::testing::ValuesIn(shippedNames()),
                         [](const auto& of) { return of.param; });

TEST(Recipe, OtherSeedsAndIndicesGiveOtherScenes) {
  const Recipe recipe;
  const Scene one = recipeScene(recipe, 3, 5);
  EXPECT_FALSE(one.camera.world_from_camera.isApprox(recipeScene(recipe, 3, 6).camera.world_from_camera));
  EXPECT_FALSE(one.camera.world_from_camera.isApprox(recipeScene(recipe, 4, 5).camera.world_from_camera));
  EXPECT_FALSE(one.camera.world_from_camera.isApprox(recipeScene(recipe, 5, 3).camera.world_from_camera));
}

TEST(Recipe, KeepsItsRanges) {
  const Recipe recipe;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = recipeScene(recipe, seed, 0);
    const int count = static_cast<int>(scene.boxes.size());
    EXPECT_GE(count, recipe.groups.front().count.min);
    EXPECT_LE(count, recipe.groups.front().count.max);
    for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
      EXPECT_TRUE(recipe.boxes.size_x_m.contains(scene.boxes[i].size_m.x()));
      EXPECT_TRUE(recipe.boxes.size_y_m.contains(scene.boxes[i].size_m.y()));
      EXPECT_TRUE(recipe.boxes.size_z_m.contains(scene.boxes[i].size_m.z()));
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(geometry::distance(footprint(scene.boxes[i]), footprint(scene.boxes[j])),
                  recipe.boxes.gap_m);
      }
    }
    const geometry::Pose& pose = scene.camera.world_from_camera;
    const double tilt = std::acos(-pose.linear()(2, 2));
    EXPECT_GE(tilt, recipe.view.tilt_rad.min - 1e-9);
    EXPECT_LE(tilt, recipe.view.tilt_rad.max + 1e-9);
    const double distance = pose.translation().z() / std::cos(tilt);
    EXPECT_GE(distance, recipe.view.distance_m.min - 1e-9);
    EXPECT_LE(distance, recipe.view.distance_m.max + 1e-9);
  }
}

TEST(Recipe, SeparatedBoxesAreInFullSight) {
  const Recipe recipe = loadRecipe(shipped("separated_depth_noise"));
  for (std::uint64_t index = 0; index < 8; ++index) {
    for (const double share : visibilityOf(recipeScene(recipe, 21, index))) EXPECT_GE(share, 0.97) << index;
  }
}

TEST(Recipe, TouchingBoxesStandFaceToFace) {
  for (const bool stepped : {false, true}) {
    const Recipe recipe = loadRecipe(shipped(stepped ? "touching_stepped" : "touching_equal"));
    for (std::uint64_t index = 0; index < 10; ++index) {
      SCOPED_TRACE(recipe.name + ", scene " + std::to_string(index));
      const Scene scene = recipeScene(recipe, 22, index);
      ASSERT_GE(scene.boxes.size(), 2u);
      EXPECT_LE(geometry::distance(footprint(scene.boxes[0]), footprint(scene.boxes[1])), 0.002 + 1e-9);
      EXPECT_EQ(scene.boxes[0].yaw_rad, scene.boxes[1].yaw_rad);
      const double step = std::abs(scene.boxes[0].size_m.z() - scene.boxes[1].size_m.z());
      EXPECT_TRUE(stepped ? step > 0.0099 : step == 0.0) << step;
    }
  }
}

TEST(Recipe, HiddenTopsAreHiddenAsMuchAsAsked) {
  Recipe recipe = loadRecipe(shipped("hidden"));
  recipe.scene.camera.projector_m.reset();  // its shadow is a part of what is asked, not of the image's share
  for (std::uint64_t index = 0; index < 10; ++index) {
    const std::vector<double> visibility = visibilityOf(recipeScene(recipe, 23, index));
    ASSERT_GE(visibility.size(), 2u);
    EXPECT_GT(visibility[0], 0.36) << index;
    EXPECT_LT(visibility[0], 0.96) << index;
    EXPECT_GT(visibility[1], 0.96) << index;
  }
}

TEST(Recipe, CutBoxesReachOverTheImagesBorder) {
  const Recipe recipe = loadRecipe(shipped("truncated"));
  for (std::uint64_t index = 0; index < 10; ++index) {
    const std::vector<double> visibility = visibilityOf(recipeScene(recipe, 24, index));
    ASSERT_GE(visibility.size(), 1u);
    EXPECT_GT(visibility[0], 0.26) << index;
    EXPECT_LT(visibility[0], 0.94) << index;
  }
}

TEST(Recipe, StacksStandOnWhatIsBelow) {
  const Recipe recipe = loadRecipe(shipped("stacked"));
  for (std::uint64_t index = 0; index < 5; ++index) {
    const Scene scene = recipeScene(recipe, 25, index);
    ASSERT_EQ(scene.objects.size(), 1u);
    const double deck = extentOf(*scene.objects[0].mesh).high.z();
    EXPECT_TRUE(recipe.groups.front().pallet_height_m.contains(deck)) << deck;
    EXPECT_TRUE(warnings(scene).empty()) << index;
    for (const SceneBox& box : scene.boxes) {
      const bool supported =
          std::abs(box.base_z_m - deck) < kSinglePrecisionM ||
          std::any_of(scene.boxes.begin(), scene.boxes.end(), [&](const SceneBox& below) {
            return std::abs(below.base_z_m + below.size_m.z() - box.base_z_m) < kSinglePrecisionM &&
                   geometry::distance(footprint(box), footprint(below)) == 0.0;
          });
      EXPECT_TRUE(supported) << index;
    }
  }
}

TEST(Recipe, SaysWhenThereIsNoRoom) {
  Recipe recipe;
  recipe.groups.front().count = {50, 50};
  EXPECT_THROW(recipeScene(recipe, 1, 0), std::runtime_error);
}

TEST(Recipe, NamesEveryBrokenRule) {
  EXPECT_TRUE(problems(Recipe()).empty());
  Recipe recipe;
  recipe.groups.front().count = {3, 2};
  recipe.boxes.size_x_m = {-1.0, 0.2};
  recipe.boxes.gap_m = std::numeric_limits<double>::quiet_NaN();
  recipe.view.distance_m = {500.0, 600.0};
  recipe.view.tilt_rad.max = 2.0;
  recipe.view.border_px_ratio = 0.6;
  recipe.paint.carton_rgb.clear();
  recipe.sensor.dropout_ratio = Range{0.5, 1.5};
  recipe.boxes_total = {-1, 3};
  recipe.scene.camera.width_px = 0;
  EXPECT_EQ(problems(recipe).size(), 10u);
  EXPECT_THROW(recipeScene(recipe, 1, 0), std::invalid_argument);
}

class RecipeFile : public TemporaryFolder {
 protected:
  void expectError(const std::string& text, int line, const std::string& mistake) const {
    const std::string expected = path("r.yaml") + ":" + std::to_string(line) + ": " + mistake;
    std::string found;
    try {
      loadRecipe(write("r.yaml", text));
    } catch (const std::invalid_argument& error) {
      found = error.what();
    }
    EXPECT_NE(found.find(expected), std::string::npos) << "not '" << expected << "' but '" << found << "'";
  }
};

TEST_F(RecipeFile, NamesFileLineAndKey) {
  expectError("views: {}\n", 1, "views: is no known key");
  expectError("view:\n  distance_m: [2, 1]\n", 2, "view.distance_m: [2, 1] is no range");
  expectError("view:\n  tilt_deg: [0, 95]\n", 2, "view.tilt_deg: [0, 95] is no range within [0, 85]");
  expectError("boxes:\n  size_x_m: [1, 2, 3]\n", 2, "boxes.size_x_m: is no list of 2 finite numbers");
  expectError("groups:\n  - count: [1, 2]\n  - arrangement: pile\n", 3,
              "groups[1].arrangement: 'pile' is none of apart, touching, hidden, cut, stack");
  expectError("groups:\n  - arrangement: apart\n    layers: 2\n", 3, "groups[0].layers: is no known key");
  expectError("groups:\n  - count: [1, 2, 3]\n", 2, "groups[0].count: is no integer or list of 2 integers");
  expectError("camera:\n  eye_m: [0, 0, 1]\n", 2, "camera.eye_m: is no known key");
  expectError("noise: {dropout_ratio: 3}\n", 1, "noise.dropout_ratio: 3 is not in [0, 1]");
  expectError("paint:\n  carton_rgb: red\n", 2, "paint.carton_rgb: is no list of colours 0xRRGGBB");
  EXPECT_THROW(loadRecipe(path("absent.yaml")), std::runtime_error);
}

TEST_F(RecipeFile, OneNumberIsARangeOfItsOwn) {
  const Recipe recipe =
      loadRecipe(write("one.yaml", "view: {distance_m: 1.5, tilt_deg: 30}\ngroups: [{count: 2}]\n"));
  EXPECT_EQ(recipe.name, "one");
  EXPECT_EQ(recipe.view.distance_m.min, 1.5);
  EXPECT_EQ(recipe.view.distance_m.max, 1.5);
  EXPECT_NEAR(recipe.view.tilt_rad.max, M_PI / 6, 1e-12);
  EXPECT_EQ(recipe.groups.front().count.max, 2);
}

}  // namespace
}  // namespace mixed_palletizing::simulation
