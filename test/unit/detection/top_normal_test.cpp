// How far a top leans.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/box_detector.hpp>

#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kHeight = 0.20;

/// One carton that leans by `lean_rad` about its long side, on a level floor.
Detections detectLeaning(double lean_rad, Mode mode, std::uint64_t seed) {
  simulation::Scene scene = test::sceneRecipe(0.0002, 1200, 750).scene;
  simulation::SceneObject carton;
  carton.mesh = std::make_shared<simulation::TriangleMesh>(simulation::cuboidMesh({0.30, 0.24, kHeight}));
  carton.world_from_object = simulation::poseFromRollPitchYaw({0.0, 0.0, 0.0}, {lean_rad, 0.0, 0.0});
  scene.objects = {carton};
  scene.has_marker = false;
  scene.camera.world_from_camera = simulation::lookAt({0.1, -0.3, 1.6}, {0.0, 0.0, 0.0});
  const auto capture = simulation::capture(scene, seed);
  DetectionOptions options;
  options.mode = mode;
  BoxDetector detector(options);
  return detector.detect(capture.cloud.view(), scene.camera.world_from_camera);
}

TEST(TopNormal, saysHowFarATopLeans) {
  for (const Mode mode : {Mode::kPalletize, Mode::kDepalletize}) {
    for (const double lean_rad : {0.0, 0.01, 0.05}) {
      SCOPED_TRACE(std::string(mode == Mode::kPalletize ? "palletize" : "depalletize") + ", leaning by " +
                   std::to_string(lean_rad));
      const Detections found = detectLeaning(lean_rad, mode, 311);
      ASSERT_EQ(found.boxes.size(), 1u);
      const DetectedBox& box = found.boxes[0];
      EXPECT_NEAR(box.top_center.z(), kHeight, 0.003);
      const Eigen::Vector3d normal(0.0, -std::sin(lean_rad), std::cos(lean_rad));
      EXPECT_NEAR(box.top_normal.norm(), 1.0, 1e-9);
      EXPECT_LT((box.top_normal - normal).norm(), 0.002) << box.top_normal.transpose();
      EXPECT_EQ((box.flags & kUnevenTop) != 0, lean_rad > 0.04);
    }
  }
}

}  // namespace
}  // namespace mixed_palletizing::detection
