// The truth says what the capture and the scene hold.
#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <mixed_palletizing/simulation/truth_json.hpp>

#include "small_scenes.hpp"

namespace mixed_palletizing::simulation {
namespace {

using nlohmann::json;

Eigen::Vector3d toVector(const json& numbers) {
  const std::array<double, 3> v = numbers;
  return {v[0], v[1], v[2]};
}

TEST(TruthJson, SayWhatIsThere) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = smallScene(seed);
    scene.marker.position_m = {0.01, 0.02};
    scene.marker.yaw_rad = 0.4;
    const Capture result = capture(scene, seed);
    const json truth = json::parse(truthJson(scene, result, seed));
    EXPECT_EQ(truth.at("seed"), seed);
    for (int row = 0; row < 4; ++row) {
      for (int col = 0; col < 4; ++col) {
        const double value =
            truth.at("world_from_camera").at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(col));
        EXPECT_EQ(value, scene.camera.world_from_camera.matrix()(row, col));
      }
    }
    ASSERT_EQ(truth.at("boxes").size(), scene.boxes.size());
    for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
      const json& box = truth.at("boxes").at(i);
      const Eigen::Vector3d size = toVector(box.at("size"));
      EXPECT_GE(size.x(), size.y());
      EXPECT_NEAR(size.prod(), scene.boxes[i].size_m.prod(), 1e-12);
      EXPECT_EQ(toVector(box.at("center")).z(), 0.5 * scene.boxes[i].size_m.z());
      EXPECT_TRUE((toVector(box.at("top_center")) - toVector(box.at("center")))
                      .isApprox(Eigen::Vector3d(0, 0, 0.5 * size.z())));
      const double yaw = box.at("yaw");
      EXPECT_TRUE(yaw >= -1.5707963267948968 && yaw < 1.5707963267948968) << yaw;
      const Eigen::Vector3d end =
          worldFromBox(scene.boxes[i]).inverse() *
          (toVector(box.at("center")) + 0.5 * size.x() * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0));
      EXPECT_NEAR(end.cwiseAbs().maxCoeff(), 0.5 * size.x(), 1e-9);  // the length runs along the yaw
      const std::array<double, 4> q = box.at("pose").at("orientation");
      const Eigen::Matrix3d turned = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix();
      EXPECT_TRUE(turned.col(0).isApprox(Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0)));
      EXPECT_EQ(toVector(box.at("pose").at("position")), toVector(box.at("center")));
      EXPECT_TRUE((scene.camera.world_from_camera * toVector(box.at("pose_in_camera").at("position")))
                      .isApprox(toVector(box.at("center"))));
      EXPECT_EQ(box.at("mask_value"), i + 1);
      EXPECT_GT(box.at("visibility"), 0.0);
      EXPECT_LE(box.at("visibility"), 1.0);
      EXPECT_EQ(box.at("visible_pixels"), result.visible_pixels[i]);
      EXPECT_EQ(box.at("top_visibility"), result.top_visibility[i]);
      EXPECT_EQ(box.at("name"), scene.boxes[i].name);
    }
  }
}

TEST(TruthJson, TopsSayHowUnevenTheyAre) {
  Scene scene = smallScene(1);
  SceneBox& box = scene.boxes[0];
  const double nominal = box.base_z_m + box.size_m.z();
  json truth = json::parse(truthJson(scene, capture(scene, 1), 1)).at("boxes").at(0);
  EXPECT_EQ(truth.at("top_mean_height"), nominal);
  EXPECT_EQ(truth.at("top_max_deviation"), 0.0);
  EXPECT_TRUE(truth.at("shape_flags").empty());
  box.shape.bulge_m = -0.006;
  truth = json::parse(truthJson(scene, capture(scene, 1), 1)).at("boxes").at(0);
  EXPECT_NEAR(truth.at("top_mean_height"), nominal - 0.006 * 4.0 / 9.0, 1e-6);
  EXPECT_NEAR(truth.at("top_max_deviation"), 0.006, 1e-9);
  EXPECT_EQ(truth.at("shape_flags"), json::array({"SAGGED"}));
  EXPECT_EQ(toVector(truth.at("size")).z(), box.size_m.z());
}

TEST(TruthJson, VisibilityIsTheShareOfWhatTheBoxWouldShowAlone) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Scene scene = smallScene(seed);
    scene.boxes.resize(1);
    const json alone = json::parse(truthJson(scene, capture(scene, 1), 1)).at("boxes").at(0);
    EXPECT_NEAR(alone.at("visibility"), 1.0, 0.03) << "seed " << seed;
  }
}

TEST(TruthJson, BaseFrameIsTheMarkers) {
  Scene scene = smallScene(1);
  scene.marker.position_m = {0.01, 0.02};
  const Capture result = capture(scene, 1);
  const json with_marker = json::parse(truthJson(scene, result, 1));
  const double x = with_marker.at("base_from_camera").at(0).at(3);
  EXPECT_NEAR(x, scene.camera.world_from_camera.translation().x() - 0.01, 1e-12);
  scene.has_marker = false;
  scene.boxes[0].name = "";
  const json without = json::parse(truthJson(scene, result, 1));
  EXPECT_TRUE(without.at("base_from_camera").is_null());
  EXPECT_EQ(without.at("boxes").at(0).at("name"), "box_1");
}

}  // namespace
}  // namespace mixed_palletizing::simulation
