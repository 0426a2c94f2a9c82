// Where walks over a top end.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/box_detector.hpp>
#include <mixed_palletizing/simulation/scene_box.hpp>

#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

using simulation::Scene;
using simulation::SceneBox;

constexpr double kLevel = 0.003;   // [m] around a top
constexpr double kBeside = 0.006;  // [m] of a side

/// How far inside of a top's sides a place lies; below 0 outside of all tops.
double insideOf(const Scene& scene, const Eigen::Vector3d& place) {
  double most = -INFINITY;
  for (const SceneBox& box : scene.boxes) {
    if (std::abs(place.z() - box.size_m.z()) > kLevel) continue;
    const Eigen::Vector2d d = place.head<2>() - box.position_m;
    const double c = std::cos(box.yaw_rad);
    const double s = std::sin(box.yaw_rad);
    const Eigen::Array2d local(c * d.x() + s * d.y(), c * d.y() - s * d.x());
    most = std::max(most, (0.5 * box.size_m.head<2>().array() - local.abs()).minCoeff());
  }
  return most;
}

/// A long box behind a gap of one or two pixels beside a shorter one of the same height.
Scene besideEachOther(std::uint64_t seed, double gap_m) {
  Scene scene = simulation::recipeScene(test::sceneRecipe(0.0002, 1920, 1200), seed, 0);
  SceneBox first = scene.boxes.front();
  first.size_m = {0.15, 0.18, 0.06};
  const Eigen::Vector2d along(std::cos(first.yaw_rad), std::sin(first.yaw_rad));
  SceneBox second = first;
  second.size_m = {0.34, 0.12, 0.06};
  first.position_m = -0.17 * along;
  second.position_m = first.position_m + (0.245 + gap_m) * along;
  scene.boxes = {first, second};
  scene.has_marker = false;
  scene.camera.world_from_camera = simulation::lookAt({0.25, -0.2, 1.15}, {0.0, 0.0, 0.0});
  return scene;
}

TEST(EdgeWalks, endNowhereInsideOfAPlainTop) {
  for (std::uint64_t seed = 60; seed < 64; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = besideEachOther(seed, 0.001 + 0.0002 * static_cast<double>(seed - 60));
    const auto capture = simulation::capture(scene, seed);
    BoxDetector detector{DetectionOptions()};
    const auto view = capture.cloud.view();
    const geometry::Pose pose = scene.camera.world_from_camera;
    const Detections found = detector.detect(view, pose, true);
    EXPECT_EQ(found.boxes.size(), 2u);
    const auto edges =
        std::find_if(found.stage_pixels.begin(), found.stage_pixels.end(),
                     [](const StagePixels& stage) { return stage.stage == std::string("edges"); });
    ASSERT_NE(edges, found.stage_pixels.end());
    EXPECT_GT(edges->pixels.size(), 500u);
    int astray = 0;
    for (const std::uint32_t pixel : edges->pixels) {
      const int width = view.width;
      const Eigen::Vector3f p = view.point(static_cast<int>(pixel) / width, static_cast<int>(pixel) % width);
      astray += insideOf(scene, pose * p.cast<double>()) > kBeside ? 1 : 0;
    }
    EXPECT_EQ(astray, 0);
  }
}

TEST(EdgeWalks, aNarrowShadowBelongsToNoTop) {
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE("seed " + std::to_string(64 + i));
    Scene scene = test::sceneRecipe(0.0002, 1280, 800).scene;
    scene.has_marker = false;
    SceneBox box;
    box.size_m = {0.2, 0.15, 0.08};
    box.yaw_rad = 0.1 + 0.4 * i;
    scene.boxes = {box};
    scene.camera.world_from_camera = simulation::lookAt({0.02, -0.03, 1.2}, {0.0, 0.0, 0.0});
    scene.camera.projector_m = Eigen::Vector3d(0.02 + 0.01 * i, 0.0, 0.0);  // shadows of 1.4 to 3.6 mm
    const auto capture = simulation::capture(scene, 64 + static_cast<std::uint64_t>(i));
    BoxDetector detector{DetectionOptions()};
    const Detections found = detector.detect(capture.cloud.view(), scene.camera.world_from_camera);
    ASSERT_EQ(found.boxes.size(), 1u);
    EXPECT_LT((found.boxes[0].size - box.size_m).head<2>().cwiseAbs().maxCoeff(), 0.0004);
  }
}

}  // namespace
}  // namespace mixed_palletizing::detection
