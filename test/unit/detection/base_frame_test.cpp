#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <mixed_palletizing/detection/base_frame.hpp>

#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

using simulation::Scene;

void expectNear(const geometry::Pose& found, const geometry::Pose& truth, double position_m, double angle_rad,
                const std::string& what) {
  const geometry::Pose error = found * truth.inverse();
  EXPECT_LT(error.translation().norm(), position_m) << what;
  EXPECT_LT(std::abs(Eigen::AngleAxisd(error.linear()).angle()), angle_rad) << what;
}

TEST(FindBaseFrame, findsTheMarkerOfRandomViews) {
  for (std::uint64_t seed = 400; seed < 412; ++seed) {
    auto recipe = test::sceneRecipe(0.0003, 960, 600);
    recipe.scene.marker.inverted = seed % 2 == 0;
    recipe.scene.marker.yaw_rad = 0.7 * static_cast<double>(seed);
    recipe.scene.marker.dictionary = seed % 3 == 0 ? "DICT_5X5_100" : "DICT_4X4_50";
    recipe.scene.noise.no_data_on_black = seed % 4 != 3;
    const Scene scene = simulation::recipeScene(recipe, seed, 0);
    const auto capture = simulation::capture(scene, seed);
    DetectionOptions detection;
    detection.marker.dictionary = scene.marker.dictionary;
    const auto result = findBaseFrame(capture.cloud.view(), BaseFrameSource::kMarker, detection);
    ASSERT_TRUE(result.frame) << result.message << ", seed " << seed;
    expectNear(result.frame->base_from_camera, test::trueBaseFromCamera(scene), 0.0003, 0.0005,
               "seed " + std::to_string(seed));
    ASSERT_FALSE(result.frame->markers.empty());
    EXPECT_EQ(result.frame->markers.front().id, 0);
    const geometry::Pose camera_from_world = scene.camera.world_from_camera.inverse();
    const auto corners = simulation::markerCorners(scene.marker);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT((result.frame->markers.front().corners[i] - camera_from_world * corners[i]).norm(), 0.0004);
    }
  }
}

TEST(FindBaseFrame, putsTheFloorsOriginUnderTheCamera) {
  const Scene scene = simulation::recipeScene(test::sceneRecipe(0.0003, 640, 400), 31, 0);
  const auto capture = simulation::capture(scene, 31);
  const auto result = findBaseFrame(capture.cloud.view(), BaseFrameSource::kFloor, DetectionOptions());
  ASSERT_TRUE(result.frame) << result.message;
  const geometry::Pose& pose = result.frame->base_from_camera;
  EXPECT_LT(pose.translation().head<2>().norm(), 1e-9);
  EXPECT_NEAR(pose.translation().z(), scene.camera.world_from_camera.translation().z(), 0.0005);
  EXPECT_NEAR(pose.linear()(1, 0), 0.0, 1e-9);
  EXPECT_GT(pose.linear()(0, 0), 0.0);
  EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-9);
}

TEST(FindBaseFrame, saysWhatItSawInsteadOfTheMarker) {
  auto recipe = test::sceneRecipe(0.0003, 960, 600);
  recipe.scene.marker.id = 7;
  const Scene scene = simulation::recipeScene(recipe, 32, 0);
  auto capture = simulation::capture(scene, 32);
  const auto other = findBaseFrame(capture.cloud.view(), BaseFrameSource::kMarker, DetectionOptions());
  EXPECT_FALSE(other.frame);
  EXPECT_NE(other.message.find("marker 0 of DICT_4X4_50 not seen; seen: 7"), std::string::npos)
      << other.message;

  DetectionOptions not_inverted;
  not_inverted.marker.id = 7;
  not_inverted.marker.inverted = false;
  const auto none = findBaseFrame(capture.cloud.view(), BaseFrameSource::kMarker, not_inverted);
  EXPECT_NE(none.message.find("no marker of that dictionary"), std::string::npos) << none.message;

  capture.cloud.has_color = false;
  const auto gray = findBaseFrame(capture.cloud.view(), BaseFrameSource::kMarker, DetectionOptions());
  EXPECT_NE(gray.message.find("no colour"), std::string::npos) << gray.message;
}

TEST(AverageBaseFrames, averagesAndReportsTheSpread) {
  BaseFrame a;
  a.base_from_camera = geometry::poseFromYaw({1.0, 2.0, 3.0}, 0.10);
  a.plane_rms_m = 0.001;
  a.plane_inliers = 10;
  BaseFrame b = a;
  b.base_from_camera = geometry::poseFromYaw({1.0, 2.0, 3.0}, 0.12);
  b.plane_rms_m = 0.003;
  const AveragedBaseFrame mean = averageBaseFrames({a, b});
  EXPECT_NEAR(geometry::yawOf(mean.frame.base_from_camera), 0.11, 1e-9);
  EXPECT_NEAR(mean.spread_rad, 0.01, 1e-9);
  EXPECT_GT(mean.spread_m, 0.0);
  EXPECT_EQ(mean.frame.plane_inliers, 20u);
  EXPECT_NEAR(mean.frame.plane_rms_m, 0.002, 1e-12);
  const AveragedBaseFrame single = averageBaseFrames({a});
  EXPECT_LT((single.frame.base_from_camera.matrix() - a.base_from_camera.matrix()).norm(), 1e-9);
  EXPECT_NEAR(single.spread_m, 0.0, 1e-9);
  EXPECT_THROW(averageBaseFrames({}), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::detection
