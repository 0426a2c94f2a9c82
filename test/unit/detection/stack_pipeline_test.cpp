// Mode depalletize on simulated stacks.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/box_detector.hpp>

#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

using simulation::Scene;

/// A pallet of 0.1 m with two layers: five boxes below, two on top of them, seen from `eye`.
Scene stackScene(const Eigen::Vector3d& eye, double noise_at_1m_m) {
  Scene scene = test::sceneRecipe(noise_at_1m_m, 1200, 750).scene;
  scene.has_marker = false;
  simulation::SceneBox pallet;
  pallet.size_m = {0.9, 0.7, 0.1};
  pallet.rgb = 0x9a8f80;
  scene.boxes.push_back(pallet);
  const auto add = [&](double x, double y, double base_z, const Eigen::Vector3d& size) {
    simulation::SceneBox box;
    box.size_m = size;
    box.position_m = {x, y};
    box.base_z_m = base_z;
    scene.boxes.push_back(box);
  };
  add(-0.25, 0.15, 0.1, {0.30, 0.20, 0.15});
  add(0.10, 0.15, 0.1, {0.30, 0.20, 0.15});
  add(-0.25, -0.15, 0.1, {0.24, 0.18, 0.12});
  add(0.10, -0.15, 0.1, {0.20, 0.20, 0.20});
  add(0.33, 0.0, 0.1, {0.10, 0.30, 0.08});
  add(-0.25, 0.14, 0.25, {0.20, 0.12, 0.10});
  scene.camera.world_from_camera = simulation::lookAt(eye, {0.0, 0.0, 0.2});
  return scene;
}

TEST(StackPipeline, findsEveryFullyVisibleTopAtItsHeight) {
  for (const double noise : {0.0, 0.0003}) {
    const Scene scene = stackScene({0.15, -0.25, 2.4}, noise);
    const auto capture = simulation::capture(scene, 71);
    DetectionOptions options;
    options.mode = Mode::kDepalletize;
    options.stack.min_height_m = 0.12;  // above the pallet
    BoxDetector detector(options);
    const Detections found = detector.detect(capture.cloud.view(), scene.camera.world_from_camera);
    for (std::size_t i = 2; i < scene.boxes.size(); ++i) {  // the first box carries another one
      const simulation::SceneBox& box = scene.boxes[i];
      test::TrueBox truth;
      truth.top_center << box.position_m, box.base_z_m + box.size_m.z();
      truth.size = box.size_m;
      if (truth.size.x() < truth.size.y()) std::swap(truth.size.x(), truth.size.y());
      const DetectedBox* match = test::nearest(found, truth);
      ASSERT_NE(match, nullptr) << "box " << i << ", noise " << noise << ", found " << found.boxes.size();
      EXPECT_LT((match->top_center - truth.top_center).norm(), 0.005) << "box " << i;
      EXPECT_LT((match->size - truth.size).head<2>().cwiseAbs().maxCoeff(), 0.004) << "box " << i;
      const bool known = (match->flags & kHeightUnknown) == 0;
      EXPECT_EQ(known, match->size_stddev.z() < 0.02) << "box " << i;
      if (known) {
        EXPECT_NEAR(match->size.z(), truth.size.z(), 0.005) << "box " << i;
      }
      EXPECT_GT(match->point_count, 1000u) << "box " << i;
    }
  }
}

TEST(StackPipeline, saysWhenNoSideOfABoxIsSeen) {
  // Nine equal boxes with small gaps: straight above the middle one only tops are seen.
  Scene scene = test::sceneRecipe(0.0002, 1200, 750).scene;
  scene.has_marker = false;
  for (int i = 0; i < 9; ++i) {
    simulation::SceneBox box;
    box.size_m = {0.20, 0.16, 0.15};
    box.position_m = {0.203 * (i % 3 - 1), 0.163 * (i / 3 - 1)};
    scene.boxes.push_back(box);
  }
  scene.camera.world_from_camera = simulation::lookAt({0.0, 0.0, 1.5}, {0.0, 0.0, 0.0});
  const auto capture = simulation::capture(scene, 72);
  DetectionOptions options;
  options.mode = Mode::kDepalletize;
  BoxDetector detector(options);
  const Detections found = detector.detect(capture.cloud.view(), scene.camera.world_from_camera);
  EXPECT_EQ(found.boxes.size(), 9u);
  for (const DetectedBox& box : found.boxes) {
    if (box.top_center.head<2>().norm() > 0.05) continue;
    EXPECT_TRUE(box.flags & kHeightUnknown);
    EXPECT_TRUE(box.flags & kTouching);
    EXPECT_GT(box.size_stddev.z(), 0.02);
    EXPECT_NEAR(box.size.x(), 0.20, 0.008);
    EXPECT_NEAR(box.size.y(), 0.16, 0.008);
  }
}

TEST(StackPipeline, ignoresWhatLiesOutsideOfTheRegion) {
  const Scene scene = stackScene({0.15, -0.25, 2.4}, 0.0003);
  const auto capture = simulation::capture(scene, 73);
  for (const Mode mode : {Mode::kDepalletize, Mode::kPalletize}) {
    DetectionOptions options;
    options.mode = mode;
    options.region.polygon_m = {-0.02, -0.28, 0.23, -0.28, 0.23, -0.02, -0.02, -0.02};
    options.stack.min_height_m = options.cluster.min_height_m = 0.12;
    BoxDetector detector(options);
    const Detections found = detector.detect(capture.cloud.view(), scene.camera.world_from_camera);
    ASSERT_EQ(found.boxes.size(), 1u);
    EXPECT_NEAR(found.boxes[0].top_center.x(), 0.10, 0.003);
    EXPECT_NEAR(found.boxes[0].top_center.y(), -0.15, 0.003);
  }
}

TEST(StackPipeline, anEmptyPalletHoldsNothing) {
  Scene scene = test::sceneRecipe(0.0003, 640, 400).scene;
  scene.has_marker = false;
  scene.camera.world_from_camera = simulation::lookAt({0.1, 0.0, 1.5}, {0.0, 0.0, 0.0});
  const auto capture = simulation::capture(scene, 74);
  DetectionOptions options;
  options.mode = Mode::kDepalletize;
  BoxDetector detector(options);
  EXPECT_TRUE(detector.detect(capture.cloud.view(), scene.camera.world_from_camera, true).boxes.empty());
}

}  // namespace
}  // namespace mixed_palletizing::detection
