#include <atomic>

#include <gtest/gtest.h>

#include <mixed_palletizing/experiments/detection_summary.hpp>
#include <mixed_palletizing/experiments/record_json.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace mixed_palletizing::experiments {
namespace {

/// Small pictures of one or two boxes and a marker.
SceneSource smallScenes(std::uint64_t seed) {
  simulation::Recipe recipe;
  recipe.groups.front().count = {1, 2};
  recipe.view.distance_m = {1.3, 1.4};
  recipe.scene.camera.width_px = 640;
  recipe.scene.camera.height_px = 400;
  recipe.scene.noise.depth_stddev_at_1m_m = 0.0002;
  return {[recipe, seed](std::uint64_t index) { return simulation::recipeScene(recipe, seed, index); },
          [seed](std::uint64_t index) { return seed + index; }};
}

/// Without times, which differ from run to run.
std::string text(SceneRecord record) {
  record.detect_ms = 0.0;
  record.base_ms = 0.0;
  return recordJson(record);
}

TEST(MeasureScenes, FindsTheBoxesWhereverTheBaseFrameComesFrom) {
  const std::uint64_t seed = 40;
  SCOPED_TRACE(seed);
  for (const BaseSource base : {BaseSource::kMarker, BaseSource::kTruth}) {
    MeasurementOptions options;
    options.base = base;
    const DetectionSummary summary = summarize(measureScenes(smallScenes(seed), 0, 4, options, 1));
    EXPECT_EQ(summary.base_found, 4u);
    EXPECT_EQ(summary.found, summary.boxes);
    EXPECT_GT(summary.boxes, 0u);
    EXPECT_EQ(summary.invented, 0u);
    EXPECT_LT(summary.position_mm.mean, 3.0);
    EXPECT_EQ(base == BaseSource::kTruth, summary.base_origin_mm.worst == 0.0);
  }
}

TEST(MeasureScenes, ThreadsAndStartChangeNothing) {
  const SceneSource source = smallScenes(9);
  const MeasurementOptions options;
  std::atomic<int> done{0};
  const auto two = measureScenes(source, 0, 3, options, 2, [&] { ++done; });
  EXPECT_EQ(done, 3);
  EXPECT_EQ(text(two[2]), text(measureScenes(source, 2, 1, options, 1)[0]));
  std::size_t pixels = 0;
  const SceneRecord one =
      measureScene(source, 1, options, [&](const simulation::Capture& c) { pixels = c.mask.size(); });
  EXPECT_EQ(text(two[1]), text(one));
  EXPECT_EQ(pixels, 640u * 400u);
}

TEST(MeasureScenes, SaysWhatIsWrong) {
  const SceneSource source = smallScenes(1);
  EXPECT_THROW(measureScenes(source, 0, 1, {}, 0), std::invalid_argument);
  SceneSource broken = source;
  broken.scene = [](std::uint64_t) -> simulation::Scene { throw std::runtime_error("no such scene"); };
  EXPECT_THROW(measureScenes(broken, 0, 3, {}, 2), std::runtime_error);
  EXPECT_TRUE(measureScenes(source, 0, 0, {}, 1).empty());
}

TEST(MeasureScenes, ALostMarkerIsReported) {
  SceneSource source = smallScenes(3);
  const auto scene = source.scene;
  source.scene = [scene](std::uint64_t index) {
    simulation::Scene changed = scene(index);
    changed.marker.id = 17;
    return changed;
  };
  const SceneRecord record = measureScene(source, 0, {});
  EXPECT_FALSE(record.base_found);
  EXPECT_NE(record.base_message.find("not seen"), std::string::npos) << record.base_message;
}

}  // namespace
}  // namespace mixed_palletizing::experiments
