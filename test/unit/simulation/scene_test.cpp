// Poses of a scene's things, and the rules that a scene must keep.
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include <mixed_palletizing/simulation/scene.hpp>

#include "small_scenes.hpp"

namespace mixed_palletizing::simulation {
namespace {

TEST(LookAt, PutsTheTargetOnTheOpticalAxisAndUpUp) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::srand(static_cast<unsigned>(seed));
    const Eigen::Vector3d eye = Eigen::Vector3d::Random();
    const Eigen::Vector3d target = Eigen::Vector3d::Random();
    const geometry::Pose pose = lookAt(eye, target);
    EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-12);
    EXPECT_TRUE((pose.linear() * pose.linear().transpose()).isIdentity(1e-12));
    const Eigen::Vector3d seen = pose.inverse() * target;
    EXPECT_TRUE(seen.isApprox(Eigen::Vector3d(0, 0, (target - eye).norm()), 1e-9));
    EXPECT_NEAR(pose.linear()(2, 0), 0.0, 1e-12);  // image rows are level
    EXPECT_LT(pose.linear()(2, 1), 0.0);           // image y runs down
  }
}

TEST(LookAt, StraightDownHasWorldYUp) {
  const geometry::Pose pose = lookAt({0, 0, 1}, {0, 0, 0});
  EXPECT_TRUE(pose.linear().col(0).isApprox(Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(pose.linear().col(1).isApprox(-Eigen::Vector3d::UnitY()));
  EXPECT_THROW(lookAt({1, 2, 3}, {1, 2, 3}), std::invalid_argument);
}

TEST(SceneProblems, SoundScenesHaveNone) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) EXPECT_TRUE(problems(smallScene(seed)).empty()) << seed;
}

/// The scene after `damage` has one problem, which starts with `key`.
void expectProblem(const std::string& key, const std::function<void(Scene&)>& damage) {
  Scene scene = bareFloor(1.0);
  scene.has_marker = true;
  scene.boxes.resize(2);
  scene.boxes[1].position_m = {1.0, 0.0};
  scene.boxes[1].labels.resize(1);
  ASSERT_TRUE(problems(scene).empty());
  damage(scene);
  const std::vector<std::string> found = problems(scene);
  ASSERT_EQ(found.size(), 1u) << key;
  EXPECT_EQ(found[0].substr(0, found[0].find(':')), key) << found[0];
  EXPECT_EQ(found[0].find('\n'), std::string::npos);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(SceneProblems, OfTheFloorAndTheMarker) {
  expectProblem("floor.size_m", [](Scene& s) { s.floor.size_y_m = 3000.0; });
  expectProblem("floor.rgb", [](Scene& s) { s.floor.rgb = 0x1000000; });
  expectProblem("marker.dictionary", [](Scene& s) { s.marker.dictionary = "DICT_9X9_1"; });
  expectProblem("marker.id", [](Scene& s) { s.marker.id = 50; });
  expectProblem("marker.id", [](Scene& s) { s.marker.id = -1; });
  expectProblem("marker.side_m", [](Scene& s) { s.marker.side_m = 0.0; });
  expectProblem("marker.quiet_zone_m", [](Scene& s) { s.marker.quiet_zone_m = kNan; });
  expectProblem("marker.yaw", [](Scene& s) { s.marker.yaw_rad = kNan; });
  expectProblem("marker.position_m", [](Scene& s) { s.marker.position_m.x() = 11.0; });
}

TEST(SceneProblems, OfTheCameraAndTheNoise) {
  expectProblem("camera.width_px", [](Scene& s) { s.camera.width_px = -3; });
  expectProblem("camera.width_px", [](Scene& s) { s.camera.height_px = s.camera.width_px = 1 << 20; });
  expectProblem("camera.horizontal_fov", [](Scene& s) { s.camera.horizontal_fov_rad = 3.2; });
  expectProblem("camera.world_from_camera", [](Scene& s) { s.camera.world_from_camera.linear() *= 2.0; });
  expectProblem("camera.world_from_camera",
                [](Scene& s) { s.camera.world_from_camera.translation().z() = -1.0; });
  expectProblem("camera.projector_m", [](Scene& s) { s.camera.projector_m = Eigen::Vector3d(0, 0, 2.0); });
  expectProblem("noise.depth_stddev_at_1m_m", [](Scene& s) { s.noise.depth_stddev_at_1m_m = -0.1; });
  expectProblem("noise.dropout_ratio", [](Scene& s) { s.noise.dropout_ratio = 1.5; });
  expectProblem("noise.flying_pixel_ratio", [](Scene& s) { s.noise.flying_pixel_ratio = kNan; });
  expectProblem("noise.dark_noise_gain", [](Scene& s) { s.noise.dark_noise_gain = -1.0; });
  expectProblem("noise.grazing_noise_gain", [](Scene& s) { s.noise.grazing_noise_gain = kNan; });
  expectProblem("noise.depth_edge_m", [](Scene& s) { s.noise.depth_edge_m = 0.0; });
}

TEST(SceneProblems, OfTheBoxes) {
  expectProblem("boxes[1].size_m", [](Scene& s) { s.boxes[1].size_m.z() = 0.0; });
  expectProblem("boxes[1].size_m", [](Scene& s) { s.boxes[1].size_m.x() = 300.0; });  // millimetres
  expectProblem("boxes[0].position_m", [](Scene& s) { s.boxes[0].position_m.x() = kNan; });
  expectProblem("boxes[0].base_z_m", [](Scene& s) { s.boxes[0].base_z_m = -0.01; });
  expectProblem("boxes[0].yaw", [](Scene& s) { s.boxes[0].yaw_rad = kNan; });
  expectProblem("boxes[0].rgb", [](Scene& s) { s.boxes[0].rgb = 0xff000000; });
  expectProblem("boxes[0].face_rgb", [](Scene& s) { s.boxes[0].face_rgb[2] = 0xff000000; });
  expectProblem("boxes[1].labels[0].size_m", [](Scene& s) { s.boxes[1].labels[0].size_m.x() = 0.0; });
  expectProblem("boxes[1].labels[0].center_m", [](Scene& s) { s.boxes[1].labels[0].center_m.x() = kNan; });
  expectProblem("boxes[1].labels[0].rgb", [](Scene& s) { s.boxes[1].labels[0].rgb = 0x2000000; });
  expectProblem("boxes[1]", [](Scene& s) { s.boxes[1].position_m = {0.1, 0.05}; });  // overlap
  expectProblem("boxes[0]", [](Scene& s) { s.boxes[0].size_m.z() = 1.5; });          // holds the camera
}

TEST(SceneProblems, TouchingAndStackedBoxesAreAllowed) {
  Scene scene = bareFloor(2.0);
  scene.boxes.resize(3);
  scene.boxes[1].position_m.x() = scene.boxes[0].size_m.x();
  scene.boxes[2].base_z_m = scene.boxes[0].size_m.z();
  EXPECT_TRUE(problems(scene).empty());
}

}  // namespace
}  // namespace mixed_palletizing::simulation
