#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/base_frame.hpp>
#include <mixed_palletizing/detection/box_detector.hpp>

#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

using simulation::Scene;
using simulation::SceneBox;

/// Bounds on the errors of one box.
struct Bounds {
  double position_m;
  double yaw_rad;
  double size_m;
  double height_m;
};

/// Every box is found, nothing else is, and all errors are within the bounds; base frame from the marker.
void expectAllFound(const Scene& scene, std::uint64_t seed, const DetectionOptions& options,
                    const Bounds& bounds) {
  const auto capture = simulation::capture(scene, seed);
  const auto base = findBaseFrame(capture.cloud.view(), BaseFrameSource::kMarker, options);
  ASSERT_TRUE(base.frame) << base.message << ", seed " << seed;
  BoxDetector detector(options);
  const Detections found = detector.detect(capture.cloud.view(), base.frame->base_from_camera);
  EXPECT_EQ(found.boxes.size(), scene.boxes.size()) << "seed " << seed;
  const auto truths = test::trueBoxes(scene);
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const DetectedBox* box = test::nearest(found, truths[i]);
    ASSERT_NE(box, nullptr) << "seed " << seed << ", box " << i;
    if (capture.top_visibility[i] < 0.98) continue;
    EXPECT_LT((box->top_center - truths[i].top_center).norm(), bounds.position_m)
        << "seed " << seed << ", box " << i;
    EXPECT_LT(test::yawError(*box, truths[i]), bounds.yaw_rad) << "seed " << seed << ", box " << i;
    EXPECT_LT((box->size - truths[i].size).head<2>().cwiseAbs().maxCoeff(), bounds.size_m)
        << "seed " << seed << ", box " << i;
    EXPECT_NEAR(box->size.z(), truths[i].size.z(), bounds.height_m) << "seed " << seed << ", box " << i;
    EXPECT_GT(box->top_visibility, 0.95) << "seed " << seed << ", box " << i;
    EXPECT_LT((box->center - box->top_center + 0.5 * box->size.z() * Eigen::Vector3d::UnitZ()).norm(), 1e-9);
  }
}

TEST(BoxDetector, findsEverySeparatedBoxToAFractionOfAMillimetre) {
  const Bounds bounds{0.0003, 0.0017, 0.0004, 0.0001};
  for (std::uint64_t seed = 500; seed < 506; ++seed) {
    expectAllFound(simulation::recipeScene(test::sceneRecipe(0.0002, 1920, 1200), seed, 0), seed,
                   DetectionOptions(), bounds);
  }
}

TEST(BoxDetector, staysGoodWithFourTimesTheNoiseAndCoarsePixels) {
  const Bounds bounds{0.001, 0.005, 0.0015, 0.0003};
  for (std::uint64_t seed = 520; seed < 530; ++seed) {
    expectAllFound(simulation::recipeScene(test::sceneRecipe(0.0008, 960, 600), seed, 0), seed,
                   DetectionOptions(), bounds);
  }
}

TEST(BoxDetector, standsShadowsDropOutsAndFlyingPixels) {
  const Bounds bounds{0.001, 0.005, 0.002, 0.0003};
  for (std::uint64_t seed = 540; seed < 548; ++seed) {
    auto recipe = test::sceneRecipe(0.0003, 960, 600);
    recipe.scene.camera.projector_m = Eigen::Vector3d(0.15, 0.0, 0.0);
    recipe.scene.noise.dropout_ratio = 0.01;
    recipe.scene.noise.flying_pixel_ratio = 0.5;
    expectAllFound(simulation::recipeScene(recipe, seed, 0), seed, DetectionOptions(), bounds);
  }
}

TEST(BoxDetector, findsTheSameBoxesByTheThesisAlone) {
  const Bounds bounds{0.002, 0.01, 0.004, 0.0003};
  DetectionOptions options;
  options.method = Method::kThesis;
  for (std::uint64_t seed = 560; seed < 566; ++seed) {
    expectAllFound(simulation::recipeScene(test::sceneRecipe(0.0003, 960, 600), seed, 0), seed, options,
                   bounds);
  }
}

TEST(BoxDetector, labelsThePixelsOfEachBox) {
  for (std::uint64_t seed = 580; seed < 584; ++seed) {
    const Scene scene = simulation::recipeScene(test::sceneRecipe(0.0003, 640, 400), seed, 0);
    const auto capture = simulation::capture(scene, seed);
    BoxDetector detector{DetectionOptions()};
    const Detections found = detector.detect(capture.cloud.view(), test::trueBaseFromCamera(scene));
    ASSERT_EQ(found.labels.size(), capture.mask.size());
    std::vector<std::uint32_t> counts(found.boxes.size(), 0);
    std::size_t agree = 0;
    std::size_t labelled = 0;
    for (std::size_t i = 0; i < found.labels.size(); ++i) {
      if (found.labels[i] == 0) continue;
      ASSERT_LE(found.labels[i], found.boxes.size());
      ++labelled;
      ++counts[found.labels[i] - 1u];
      if (capture.mask[i] != 0) ++agree;
    }
    EXPECT_GT(static_cast<double>(agree), 0.99 * static_cast<double>(labelled)) << "seed " << seed;
    for (std::size_t i = 0; i < counts.size(); ++i) EXPECT_EQ(counts[i], found.boxes[i].point_count);
  }
}

/// One box under a camera that looks straight down from 1.2 m.
Scene oneBox(const Eigen::Vector2d& position) {
  Scene scene;
  scene.has_marker = false;
  scene.camera.width_px = 640;
  scene.camera.height_px = 400;
  scene.camera.world_from_camera = simulation::lookAt({0.0, 0.0, 1.2}, {0.0, 0.0, 0.0});
  scene.noise.depth_stddev_at_1m_m = 0.0003;
  SceneBox box;
  box.position_m = position;
  box.yaw_rad = 0.3;
  scene.boxes.push_back(box);
  return scene;
}

Detections detectIn(const Scene& scene, const DetectionOptions& options = DetectionOptions()) {
  BoxDetector detector(options);
  const auto capture = simulation::capture(scene, 1);
  return detector.detect(capture.cloud.view(), scene.camera.world_from_camera, true);
}

TEST(BoxDetector, flagsABoxThatReachesTheBorder) {
  const Detections inside = detectIn(oneBox({0.0, 0.0}));
  ASSERT_EQ(inside.boxes.size(), 1u);
  EXPECT_EQ(inside.boxes[0].flags, 0);
  for (const double x : {0.30, 0.36}) {
    const Detections cut = detectIn(oneBox({x, 0.05}));
    for (const DetectedBox& box : cut.boxes) {
      EXPECT_TRUE(box.flags & kTruncated) << x;
      EXPECT_GT(box.size_stddev.head<2>().maxCoeff(), 0.05) << x << ": a size that cannot be known";
    }
    EXPECT_LE(cut.boxes.size(), 1u) << x;
    EXPECT_GE(cut.boxes.size() + cut.rejected.size(), 1u) << x;
  }
}

TEST(BoxDetector, flagsABoxBehindATallerOne) {
  Scene scene = oneBox({0.0, 0.12});
  scene.camera.world_from_camera = simulation::lookAt({0.0, -0.9, 1.0}, {0.0, 0.0, 0.1});
  SceneBox taller = scene.boxes[0];
  taller.size_m = Eigen::Vector3d(0.12, 0.1, 0.32);
  taller.position_m = Eigen::Vector2d(0.02, -0.1);
  taller.yaw_rad = 0.0;
  scene.boxes.push_back(taller);
  const auto capture = simulation::capture(scene, 1);
  ASSERT_LT(capture.top_visibility[0], 0.9);
  const Detections found = detectIn(scene);
  const auto truths = test::trueBoxes(scene);
  const DetectedBox* hidden = test::nearest(found, truths[0]);
  ASSERT_NE(hidden, nullptr);
  EXPECT_TRUE(hidden->flags & kOccluded);
  EXPECT_NEAR(hidden->top_visibility, capture.top_visibility[0], 0.05);
  const DetectedBox* front = test::nearest(found, truths[1]);
  ASSERT_NE(front, nullptr);
  EXPECT_FALSE(front->flags & kOccluded);
}

TEST(BoxDetector, flagsBoxesThatTouch) {
  Scene scene = oneBox({-0.16, 0.0});
  scene.boxes[0].yaw_rad = 0.0;
  SceneBox other = scene.boxes[0];
  other.size_m.z() = 0.3;
  other.position_m.x() = 0.142;  // 2 mm beside the first, which is much lower
  scene.boxes.push_back(other);
  const Detections found = detectIn(scene);
  ASSERT_EQ(found.boxes.size(), 2u);
  for (const DetectedBox& box : found.boxes) EXPECT_TRUE(box.flags & kTouching);
}

TEST(BoxDetector, saysWhySomethingIsNoBox) {
  const auto reasonOf = [](const Eigen::Vector3d& size, const DetectionOptions& options) {
    Scene scene = oneBox({0.0, 0.0});
    scene.boxes[0].size_m = size;
    const Detections found = detectIn(scene, options);
    EXPECT_TRUE(found.boxes.empty());
    EXPECT_EQ(found.rejected.size(), 1u);
    if (found.rejected.empty()) return RejectReason::kTooFewPoints;
    EXPECT_FALSE(found.rejected[0].text.empty());
    EXPECT_LT(found.rejected[0].centroid.head<2>().norm(), 0.02);
    EXPECT_GT(found.rejected[0].extent.head<2>().minCoeff(), 0.01);
    return found.rejected[0].reason;
  };
  EXPECT_EQ(reasonOf({0.10, 0.03, 0.1}, DetectionOptions()), RejectReason::kTooSmall);
  DetectionOptions small;
  small.box.max_side_m = 0.2;
  EXPECT_EQ(reasonOf({0.30, 0.10, 0.1}, small), RejectReason::kTooLarge);
  DetectionOptions many;
  many.cluster.min_points = 100000;
  EXPECT_EQ(reasonOf({0.30, 0.20, 0.1}, many), RejectReason::kTooFewPoints);
}

/// Two boxes of one height, face to face, as an L.
Scene boxesInAnL() {
  Scene scene = oneBox({0.0, 0.0});
  scene.boxes[0].size_m = Eigen::Vector3d(0.3, 0.1, 0.15);
  scene.boxes[0].yaw_rad = 0.0;
  SceneBox leg = scene.boxes[0];
  leg.size_m = Eigen::Vector3d(0.1, 0.2, 0.15);
  leg.position_m = Eigen::Vector2d(-0.1, 0.15);
  leg.rgb = 0xd0c8b8;
  scene.boxes.push_back(leg);
  return scene;
}

TEST(BoxDetector, anLOfTwoBoxesIsNotRectangularForTheThesis) {
  DetectionOptions options;
  options.method = Method::kThesis;
  const Detections found = detectIn(boxesInAnL(), options);
  EXPECT_TRUE(found.boxes.empty());
  EXPECT_TRUE(std::any_of(found.rejected.begin(), found.rejected.end(), [](const RejectedCluster& cluster) {
    return cluster.reason == RejectReason::kNotRectangular;
  }));
}

TEST(BoxDetector, explainsAnLByTwoBoxes) {
  // Where to cut it is another question: both cuts make two boxes.
  const Detections found = detectIn(boxesInAnL());
  ASSERT_EQ(found.boxes.size(), 2u);
  for (const DetectedBox& box : found.boxes) {
    EXPECT_TRUE(box.flags & kTouching);
    EXPECT_NEAR(box.size.z(), 0.15, 0.001);
  }
}

TEST(BoxDetector, keepsNothingOfTheCloudBefore) {
  BoxDetector detector{DetectionOptions()};
  const Scene first = oneBox({0.0, 0.0});
  const Scene second = oneBox({0.1, -0.05});
  const auto a = simulation::capture(first, 1);
  const auto b = simulation::capture(second, 2);
  const Detections once = detector.detect(a.cloud.view(), first.camera.world_from_camera);
  detector.detect(b.cloud.view(), second.camera.world_from_camera, true);
  const Detections again = detector.detect(a.cloud.view(), first.camera.world_from_camera);
  ASSERT_EQ(once.boxes.size(), 1u);
  ASSERT_EQ(again.boxes.size(), 1u);
  EXPECT_EQ(once.boxes[0].center, again.boxes[0].center);
  EXPECT_EQ(once.labels, again.labels);
  EXPECT_TRUE(again.stage_pixels.empty());
}

TEST(BoxDetector, showsItsStagesOnRequest) {
  const Detections found = detectIn(oneBox({0.0, 0.0}));
  std::set<std::string> names;
  for (const StagePixels& stage : found.stage_pixels) {
    names.insert(stage.stage);
    EXPECT_FALSE(stage.pixels.empty()) << stage.stage;
    for (const std::uint32_t pixel : stage.pixels) ASSERT_LT(pixel, 640u * 400u);
  }
  EXPECT_EQ(names, (std::set<std::string>{"floor", "clusters", "tops", "edges"}));
  EXPECT_FALSE(found.stage_times.empty());
  EXPECT_NEAR(found.valid_ratio, 1.0, 1e-9);
}

TEST(BoxDetector, canBeMoved) {
  BoxDetector detector{DetectionOptions()};
  BoxDetector moved = std::move(detector);
  const Scene scene = oneBox({0.0, 0.0});
  const auto capture = simulation::capture(scene, 1);
  EXPECT_EQ(moved.detect(capture.cloud.view(), scene.camera.world_from_camera).boxes.size(), 1u);
}

}  // namespace
}  // namespace mixed_palletizing::detection
