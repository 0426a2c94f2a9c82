// Changes of colour across a level surface: the border of two boxes, or print on one.
#include <cmath>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/box_detector.hpp>
#include <mixed_palletizing/simulation/scene_box.hpp>

#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

using simulation::BoxLabel;
using simulation::Scene;
using simulation::SceneBox;

constexpr std::uint32_t kBlue = 0x3a5a98;
constexpr std::uint32_t kWhite = 0xe4e2dc;
constexpr std::uint32_t kCarton = 0xa98455;
constexpr std::uint32_t kBlack = 0x0a0a0a;  // without data
constexpr std::uint32_t kPale = 0xc6bca9;

BoxLabel label(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::uint32_t rgb) {
  BoxLabel label;
  label.center_m = 0.5 * (from + to);
  label.size_m = to - from;
  label.rgb = rgb;
  return label;
}

void expectSizes(const Scene& scene, std::uint64_t seed, double side_m) {
  const auto capture = simulation::capture(scene, seed);
  BoxDetector detector{DetectionOptions()};
  const Detections found = detector.detect(capture.cloud.view(), test::trueBaseFromCamera(scene));
  ASSERT_EQ(found.boxes.size(), scene.boxes.size()) << "seed " << seed;
  for (const auto& truth : test::trueBoxes(scene)) {
    const DetectedBox* box = test::nearest(found, truth);
    ASSERT_NE(box, nullptr) << "seed " << seed;
    EXPECT_LT((box->size - truth.size).head<2>().cwiseAbs().maxCoeff(), side_m) << "seed " << seed;
  }
}

TEST(Seams, edgesOfLabelsOnOneLineAreNone) {
  for (std::uint64_t seed = 40; seed < 46; ++seed) {
    Scene scene = simulation::recipeScene(test::sceneRecipe(0.0002, 1280, 800), seed, 0);
    for (SceneBox& box : scene.boxes) {
      const Eigen::Vector2d half = 0.5 * box.size_m.head<2>();
      const double x = 0.3 * half.x();
      box.rgb = kPale;
      box.labels = {label({x, 0.05 * half.y()}, {0.9 * half.x(), 0.97 * half.y()}, kBlue),
                    label({-0.5 * half.x(), -0.97 * half.y()}, {x, 0.02 * half.y()}, kWhite)};
    }
    expectSizes(scene, seed, 0.002);
  }
}

TEST(Seams, labelsOnBothSidesOfALineAreNone) {
  for (std::uint64_t seed = 140; seed < 146; ++seed) {
    Scene scene = simulation::recipeScene(test::sceneRecipe(0.0002, 1280, 800), seed, 0);
    for (SceneBox& box : scene.boxes) {
      const Eigen::Vector2d half = 0.5 * box.size_m.head<2>();
      const double y = -0.2 * half.y();
      const double turn = 0.42 * half.x();  // the longer label ends there
      box.rgb = kCarton;
      box.labels = {label({-0.98 * half.x(), y}, {turn, 0.9 * half.y()}, kWhite),
                    label({turn, -0.9 * half.y()}, {0.98 * half.x(), y}, kWhite)};
    }
    expectSizes(scene, seed, 0.002);
  }
}

/// The label reaches from a dark band almost to the side of the box: only what lies behind the band tells.
TEST(Seams, aLabelBetweenABandAndASideIsNone) {
  for (std::uint64_t seed = 240; seed < 246; ++seed) {
    Scene scene = simulation::recipeScene(test::sceneRecipe(0.0002, 1280, 800), seed, 0);
    for (SceneBox& box : scene.boxes) {
      const Eigen::Vector2d half = 0.5 * box.size_m.head<2>();
      box.rgb = kCarton;
      box.labels = {label({0.05 * half.x(), -0.96 * half.y()}, {0.7 * half.x(), 0.3 * half.y()}, kWhite),
                    label({-half.x(), 0.3 * half.y()}, {half.x(), 0.65 * half.y()}, kBlack)};
    }
    expectSizes(scene, seed, 0.002);
  }
}

TEST(Seams, aLabelAtTheBorderDoesNotHideIt) {
  for (std::uint64_t seed = 50; seed < 56; ++seed) {
    Scene scene = simulation::recipeScene(test::sceneRecipe(0.0002, 1280, 800), seed, 0);
    SceneBox first = scene.boxes.front();
    first.size_m = {0.16, 0.12, 0.1};
    const Eigen::Vector2d along(std::cos(first.yaw_rad), std::sin(first.yaw_rad));
    first.position_m = -0.5 * first.size_m.x() * along;
    first.rgb = kCarton;
    const Eigen::Vector2d half = 0.5 * first.size_m.head<2>();
    first.labels = {label({0.4 * half.x(), 0.5 * half.y()}, {half.x(), half.y()}, kWhite)};
    SceneBox second = first;
    second.rgb = kPale;
    second.labels.clear();
    second.position_m = -first.position_m;
    scene.boxes = {first, second};
    expectSizes(scene, seed, 0.003);
  }
}

}  // namespace
}  // namespace mixed_palletizing::detection
