// What the detection takes from the heap beside the message.
#include <gtest/gtest.h>

#include <mixed_palletizing/detection/box_detector.hpp>

#include "memory_meter.hpp"
#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr std::size_t kDriversPoint = 16;  // bytes

struct Measured {
  test::MemoryUse first;   // by a new detector
  test::MemoryUse steady;  // by one that has seen such a cloud before
  std::size_t boxes = 0;
};

Measured measure(const simulation::Scene& scene, std::uint64_t seed, Mode mode) {
  const auto capture = simulation::capture(scene, seed);
  const geometry::Pose base_from_camera = test::trueBaseFromCamera(scene);
  DetectionOptions options;
  options.mode = mode;
  Measured measured;
  test::startMemoryUse();
  BoxDetector detector(options);
  detector.detect(capture.cloud.view(), base_from_camera);
  measured.first = test::memoryUse();
  test::startMemoryUse();
  measured.boxes = detector.detect(capture.cloud.view(), base_from_camera).boxes.size();
  measured.steady = test::memoryUse();
  return measured;
}

void expectWithinHalfTheMessage(const simulation::Scene& scene, const Measured& measured) {
  const auto points = static_cast<std::size_t>(scene.camera.width_px * scene.camera.height_px);
  EXPECT_GT(measured.first.peak_bytes, points * sizeof(std::uint16_t))
      << "not counted: the labels alone take as much";
  EXPECT_LE(measured.first.peak_bytes, points * kDriversPoint / 2);
}

TEST(DetectionMemory, isAtMostHalfOfTheMessage) {
  for (std::uint64_t seed = 91; seed < 93; ++seed) {
    SCOPED_TRACE(seed);
    auto recipe = test::sceneRecipe(0.0002, 1920, 1200);
    recipe.groups.front().count = {2, 4};
    const simulation::Scene scene = simulation::recipeScene(recipe, seed, 0);
    const Measured measured = measure(scene, seed, Mode::kPalletize);
    EXPECT_GT(measured.boxes, 1u);
    expectWithinHalfTheMessage(scene, measured);
  }
}

TEST(DetectionMemory, isAtMostHalfOfTheMessageWhenATopFillsTheImage) {
  simulation::Scene scene = test::sceneRecipe(0.0002, 1920, 1200).scene;
  simulation::SceneBox box;
  box.size_m = {1.4, 1.2, 0.3};
  scene.boxes.push_back(box);
  scene.camera.world_from_camera = simulation::lookAt({0.1, -0.2, 1.6}, {0.0, 0.0, 0.3});
  expectWithinHalfTheMessage(scene, measure(scene, 93, Mode::kPalletize));
}

TEST(DetectionMemory, theNextCloudTakesLittleMoreThanItsLabels) {
  const simulation::Scene scene = simulation::recipeScene(test::sceneRecipe(0.0002, 1920, 1200), 94, 0);
  const Measured measured = measure(scene, 94, Mode::kPalletize);
  const auto labels = static_cast<std::size_t>(1920 * 1200) * sizeof(std::uint16_t);
  EXPECT_LT(measured.steady.peak_bytes, labels + labels / 2);
  EXPECT_LT(measured.steady.peak_bytes, measured.first.peak_bytes);
}

TEST(DetectionMemory, theNextCloudTakesFewPieces) {
  // The answer is new for every cloud, and so are the samples that its noise is measured by; of the stages in between
  // each keeps its memory.
  for (std::uint64_t seed = 95; seed < 97; ++seed) {
    SCOPED_TRACE(seed);
    auto recipe = test::sceneRecipe(0.0002, 1920, 1200);
    recipe.groups.front().count = {3, 4};
    const Measured measured = measure(simulation::recipeScene(recipe, seed, 0), seed, Mode::kPalletize);
    EXPECT_GT(measured.boxes, 1u);
    EXPECT_LE(measured.steady.allocations, 30u);
  }
}

}  // namespace
}  // namespace mixed_palletizing::detection
