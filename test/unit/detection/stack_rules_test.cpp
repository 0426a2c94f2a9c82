// What the mode depalletize takes for no box, and why.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/box_detector.hpp>

#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

simulation::SceneBox boxAt(double x_m, double y_m, double base_z_m, const Eigen::Vector3d& size_m) {
  simulation::SceneBox box;
  box.size_m = size_m;
  box.position_m = {x_m, y_m};
  box.base_z_m = base_z_m;
  return box;
}

Detections detectFromAbove(simulation::Scene scene, std::uint64_t seed,
                           const DetectionOptions& changed = DetectionOptions()) {
  scene.has_marker = false;
  scene.camera.world_from_camera = simulation::lookAt({0.15, -0.25, 2.0}, {0.0, 0.0, 0.2});
  const auto capture = simulation::capture(scene, seed);
  DetectionOptions options = changed;
  options.mode = Mode::kDepalletize;
  BoxDetector detector(options);
  return detector.detect(capture.cloud.view(), scene.camera.world_from_camera);
}

bool isRejected(const Detections& found, RejectReason reason, const std::string& words) {
  return std::any_of(found.rejected.begin(), found.rejected.end(), [&](const RejectedCluster& cluster) {
    return cluster.reason == reason && cluster.text.find(words) != std::string::npos;
  });
}

simulation::Scene emptyScene() { return test::sceneRecipe(0.0002, 1200, 750).scene; }

TEST(StackRules, aPostIsNoBox) {
  simulation::Scene scene = emptyScene();
  scene.boxes = {boxAt(0.0, 0.0, 0.0, {0.9, 0.7, 0.1}), boxAt(0.25, 0.0, 0.1, {0.06, 0.06, 0.6}),
                 boxAt(-0.2, 0.0, 0.1, {0.25, 0.15, 0.1})};
  const Detections found = detectFromAbove(scene, 301);
  EXPECT_TRUE(isRejected(found, RejectReason::kTooLarge, "times its width: a post"));
  const auto top_at = [&](double height_m) {
    return std::count_if(found.boxes.begin(), found.boxes.end(), [&](const DetectedBox& box) {
      return std::abs(box.top_center.z() - height_m) < 0.01;
    });
  };
  EXPECT_EQ(top_at(0.2), 1) << "the carton on the pallet";
  EXPECT_EQ(top_at(0.7), 0) << "the post";
}

TEST(StackRules, aStripOfAPalletBesideABoxIsNoBox) {
  // A slab of which a box hides all but a strip along its front.
  simulation::Scene scene = emptyScene();
  scene.boxes = {boxAt(0.0, 0.0, 0.0, {0.6, 0.4, 0.1}), boxAt(0.0, 0.05, 0.1, {0.58, 0.29, 0.2})};
  const Detections found = detectFromAbove(scene, 302);
  ASSERT_EQ(found.boxes.size(), 1u);
  EXPECT_NEAR(found.boxes[0].top_center.z(), 0.3, 0.003);
  EXPECT_TRUE(isRejected(found, RejectReason::kNotRectangular, "a strip"));
}

TEST(StackRules, aLabelAcrossMostOfATopIsNoSeam) {
  simulation::Scene scene = emptyScene();
  scene.boxes = {boxAt(0.0, 0.0, 0.0, {0.26, 0.12, 0.1})};
  simulation::BoxLabel label;
  label.center_m = {0.02, 0.01};
  label.size_m = {0.07, 0.085};  // 0.7 of the width
  label.rgb = 0xf0f0e8;
  scene.boxes[0].labels.push_back(label);
  const Detections found = detectFromAbove(scene, 304);
  ASSERT_EQ(found.boxes.size(), 1u);
  EXPECT_NEAR(found.boxes[0].size.x(), 0.26, 0.005);
  EXPECT_NEAR(found.boxes[0].size.y(), 0.12, 0.005);
}

TEST(StackRules, acrossANarrowGapSizesAreLessSure) {
  simulation::Scene scene = emptyScene();
  const double gap = 0.004;
  scene.boxes = {boxAt(-0.1 - 0.5 * gap, 0.0, 0.0, {0.20, 0.15, 0.1}),
                 boxAt(0.1 + 0.5 * gap, 0.0, 0.0, {0.20, 0.15, 0.1})};
  const Detections found = detectFromAbove(scene, 305);
  ASSERT_EQ(found.boxes.size(), 2u);
  for (const DetectedBox& box : found.boxes) {
    EXPECT_LT(std::abs(box.size.x() - 0.20), 3.0 * box.size_stddev.x());
    EXPECT_GT(box.size_stddev.x(), box.size_stddev.y() + 0.0008) << "along the gap's axis";
  }
}

TEST(StackRules, besideALowerNeighbourAHeightIsNotKnown) {
  // The only foot in view is the neighbour's top; the box reaches down to the floor.
  for (const double rise : {0.03, 0.06, 0.09}) {
    simulation::Scene scene = emptyScene();
    scene.boxes = {boxAt(0.0, 0.1005, 0.0, {0.26, 0.20, 0.15 + rise}),
                   boxAt(0.0, -0.1005, 0.0, {0.26, 0.20, 0.15})};
    const Detections found = detectFromAbove(scene, 306);
    const auto tall = std::find_if(found.boxes.begin(), found.boxes.end(), [&](const DetectedBox& box) {
      return std::abs(box.top_center.z() - 0.15 - rise) < 0.01;
    });
    ASSERT_NE(tall, found.boxes.end());
    const double error = std::abs(tall->size.z() - (0.15 + rise));
    EXPECT_TRUE((tall->flags & kHeightUnknown) != 0 || error < 0.01) << rise;
    EXPECT_LT(error, 3.0 * tall->size_stddev.z()) << rise;
  }
}

TEST(StackRules, topsOfFewPointsAreNoise) {
  simulation::Scene scene = emptyScene();
  scene.boxes = {boxAt(-0.2, 0.0, 0.0, {0.25, 0.15, 0.1}), boxAt(0.2, 0.0, 0.0, {0.10, 0.08, 0.1}),
                 boxAt(0.2, 0.3, 0.0, {0.30, 0.20, 0.1})};
  DetectionOptions options;
  options.cluster.min_points = 12000;  // more than the small one has, fewer than the others
  const Detections found = detectFromAbove(scene, 303, options);
  ASSERT_EQ(found.boxes.size(), 2u);
  EXPECT_TRUE(isRejected(found, RejectReason::kTooFewPoints, "less than 12000"));
  std::vector<std::size_t> counts(3, 0);
  for (const std::uint16_t label : found.labels) {
    ASSERT_LE(label, 2);
    ++counts[label];
  }
  EXPECT_EQ(counts[1], found.boxes[0].point_count);
  EXPECT_EQ(counts[2], found.boxes[1].point_count);
}

}  // namespace
}  // namespace mixed_palletizing::detection
