#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <mixed_palletizing/experiments/top_measurement.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace mixed_palletizing::experiments {
namespace {

SceneSource smallScenes(std::uint64_t seed) {
  simulation::Recipe recipe;
  recipe.groups.front().count = {1, 2};
  recipe.view.distance_m = {1.3, 1.4};
  recipe.groups.front().top_visibility = {0.98, 1.0};
  recipe.scene.camera.width_px = 640;
  recipe.scene.camera.height_px = 400;
  recipe.scene.noise.depth_stddev_at_1m_m = 0.0002;
  return {[recipe, seed](std::uint64_t index) { return simulation::recipeScene(recipe, seed, index); },
          [seed](std::uint64_t index) { return seed + index; }};
}

TEST(MeasureTops, StudiesEveryBoxWithEveryThreshold) {
  const std::uint64_t seed = 70;
  SCOPED_TRACE(seed);
  const SceneSource source = smallScenes(seed);
  const detection::DetectionOptions options;
  for (std::uint64_t index = 0; index < 3; ++index) {
    const auto records = measureTops(source, index, options, {0.002, 0.02});
    EXPECT_EQ(records.size(), source.scene(index).boxes.size()) << "scene " << index;
    for (const TopRecord& record : records) {
      ASSERT_EQ(record.study.variants.size(), 3u);
      EXPECT_NEAR(record.study.height_m, record.truth.top_center.z(), 0.002);
      EXPECT_EQ(record.study.variants[0].threshold_m, 0.0);
      EXPECT_LT((record.center_px - record.centroid_px).norm(), 10.0);
      EXPECT_GT(record.center_px.x(), 0.0);
      EXPECT_LT(record.center_px.x(), 640.0);
      // A wider band never holds fewer points.
      EXPECT_LE(record.study.variants[1].points, record.study.variants[2].points);
    }
  }
}

TEST(MeasureTops, RecordsAreJson) {
  const SceneSource source = smallScenes(70);
  const auto records = measureTops(source, 0, {}, {0.005});
  ASSERT_FALSE(records.empty());
  const auto json = nlohmann::json::parse(topJson(records[0]));
  EXPECT_EQ(json["scene"], 0);
  EXPECT_EQ(json["variants"].size(), 2u);
  EXPECT_DOUBLE_EQ(json["variants"][1]["threshold_mm"], 5.0);
  EXPECT_FALSE(json["slices"].empty());
  EXPECT_NEAR(json["truth"]["size"][0].get<double>(), records[0].truth.size.x(), 1e-12);
}

TEST(MeasureTops, BrokenOptionsAreNamed) {
  detection::DetectionOptions options;
  options.top.slice_m = -1.0;
  EXPECT_THROW(measureTops(smallScenes(70), 0, options, {}), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::experiments
