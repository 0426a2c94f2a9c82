// Models, own intrinsics, subsampling, and the camera's keys in a scene file.
#include <cmath>
#include <functional>
#include <limits>

#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>
#include <mixed_palletizing/simulation/scene_file.hpp>

#include "analytic_rays.hpp"
#include "small_scenes.hpp"
#include "temporary_folder.hpp"

namespace mixed_palletizing::simulation {
namespace {

TEST(CameraModels, SeeTheFieldTheirMakerSays) {
  ASSERT_EQ(cameraModels().size(), 3u);
  for (const CameraModel& model : cameraModels()) {
    SCOPED_TRACE(model.name);
    const Camera camera = cameraOfModel(model.name);
    const Pinhole pinhole(camera);
    const double width =
        model.field_at_m * (pinhole.ray(camera.width_px - 0.5, 0).x() - pinhole.ray(-0.5, 0).x());
    EXPECT_NEAR(width, model.field_width_m, 1e-9);
    EXPECT_LT(model.nearest_m, model.farthest_m);
    EXPECT_LE(model.field_at_m, model.farthest_m);
    EXPECT_GT(camera.projector_m.value().x(), 0.0);
  }
  EXPECT_EQ(cameraOfModel("zivid_one").width_px, 1920);
  EXPECT_EQ(cameraOfModel("zivid_two").width_px, 1944);
  EXPECT_EQ(cameraOfModel("zivid_two_plus").height_px, 2048);
  EXPECT_THROW(cameraOfModel("zivid_nine"), std::invalid_argument);
}

Camera ownCamera() {
  Camera camera = bareFloor(1.0).camera;
  camera.intrinsics = Intrinsics{400.0, 430.0, 150.3, 110.7};
  return camera;
}

TEST(Camera, SubsampledPixelsLookThroughTheMiddleOfTheirBlock) {
  for (const Camera& full : {bareFloor(1.0).camera, ownCamera()}) {
    for (const int step : {1, 2, 4}) {
      const Camera coarse = subsampled(full, step);
      EXPECT_EQ(coarse.width_px, full.width_px / step);
      EXPECT_EQ(coarse.height_px, full.height_px / step);
      const double middle = 0.5 * (step - 1);
      for (const int i : {0, 7, 49}) {
        const Eigen::Vector3d expected = Pinhole(full).ray(step * i + middle, step * (i + 1) + middle);
        EXPECT_TRUE(Pinhole(coarse).ray(i, i + 1).isApprox(expected, 1e-12)) << step;
      }
    }
    for (const int step : {0, 3, 8, -2}) EXPECT_THROW(subsampled(full, step), std::invalid_argument);
  }
}

TEST(Camera, OwnIntrinsicsAreUsedEverywhere) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = smallScene(seed);
    scene.camera.intrinsics = ownCamera().intrinsics;
    const Capture result = capture(scene, seed);
    const Pinhole pinhole(scene.camera);
    EXPECT_EQ(pinhole.fy_px, 430.0);
    std::size_t differing = 0;
    for (int row = 0; row < scene.camera.height_px; ++row) {
      for (int col = 0; col < scene.camera.width_px; ++col) {
        const std::size_t i = pixelIndex(scene, row, col);
        if (result.mask[i] != std::max(analytic::tracePixel(scene, row, col).object, 0)) ++differing;
        const geometry::ColoredPoint& point = result.cloud.points[i];
        if (std::isnan(point.z)) continue;
        const Eigen::Vector2d image = pinhole.project({point.x, point.y, point.z});
        ASSERT_NEAR(image.x(), col, 1e-3);
        ASSERT_NEAR(image.y(), row, 1e-3);
      }
    }
    EXPECT_LE(static_cast<double>(differing), kEdgeRatio * static_cast<double>(result.mask.size()));
  }
}

TEST(Camera, RandomScenesKeepTheirPromiseWithOwnIntrinsics) {
  Recipe recipe;
  recipe.scene.camera = subsampled(cameraOfModel("zivid_two_plus"), 4);
  recipe.groups.front().top_visibility = {0.9, 1.0};
  const Scene scene = recipeScene(recipe, 3, 0);
  for (const double visibility : capture(scene, 3).top_visibility) EXPECT_GE(visibility, 0.88);
}

class CameraKeys : public TemporaryFolder {
 protected:
  Scene load(const std::string& keys, const std::string& rest = "") const {
    return loadScene(write("s.yaml", "camera:\n  eye_m: [0, 0, 1]\n  target_m: [0, 0, 0]\n" + keys + rest));
  }
  void expectError(const std::string& keys, const std::string& mistake) const {
    try {
      load(keys);
      ADD_FAILURE() << "accepted: " << keys;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("s.yaml:4: " + mistake), std::string::npos) << error.what();
    }
  }
};

TEST_F(CameraKeys, ModelSubsamplingAndIntrinsicsArrive) {
  const Camera one = load("  model: zivid_one\n").camera;
  EXPECT_EQ(one.projector_m, cameraOfModel("zivid_one").projector_m);
  EXPECT_EQ(one.world_from_camera.translation(), Eigen::Vector3d(0, 0, 1));
  EXPECT_FALSE(one.intrinsics.has_value());
  const Camera coarse = load("  model: zivid_two_plus\n  subsample: 2\n  projector_m: none\n").camera;
  EXPECT_EQ(coarse.width_px, 1224);
  EXPECT_EQ(coarse.height_px, 1024);
  EXPECT_FALSE(coarse.projector_m.has_value());
  const Intrinsics own = load("  fx_px: 1700\n  cy_px: 610\n").camera.intrinsics.value();
  EXPECT_EQ(own.fx_px, 1700.0);
  EXPECT_EQ(own.fy_px, 1700.0);
  EXPECT_EQ(own.cx_px, 959.5);
  EXPECT_EQ(own.cy_px, 610.0);
}

TEST_F(CameraKeys, IdealMeansNoNoiseAndNoProjector) {
  const std::string noise = "noise: {depth_stddev_at_1m_m: 0.001, no_data_on_black: true}\n";
  EXPECT_TRUE(load("  model: zivid_one\n", noise).noise.no_data_on_black);
  const Scene ideal = load("  model: zivid_one\n  ideal: true\n", noise);
  EXPECT_FALSE(ideal.camera.projector_m.has_value());
  EXPECT_FALSE(ideal.noise.no_data_on_black);
  EXPECT_EQ(ideal.noise.depth_stddev_at_1m_m, 0.0);
}

TEST_F(CameraKeys, MistakesAreNamed) {
  expectError("  model: zivid_nine\n", "camera.model: 'zivid_nine' is no model");
  expectError("  width_px: 640\n  model: zivid_one\n", "camera.width_px: is the model's");
  expectError("  fx_px: 1000\n  horizontal_fov_deg: 40\n",
              "camera.fx_px: says the same as horizontal_fov_deg");
  expectError("  fy_px: 1000\n", "camera.fy_px: needs fx_px");
  expectError("  fx_px: 0\n", "camera.fx_px: 0 is not in");
  expectError("  cx_px: 1.0e+9\n", "camera.cx_px: 1e+09 is not within");
  expectError("  subsample: 3\n", "camera.subsample: 3 is none of 1, 2, 4");
  expectError("  projector_m: left\n", "camera.projector_m: is no list of 3 finite numbers");
  expectError("  ideal: very\n", "camera.ideal: 'very' is no true or false");
}

}  // namespace
}  // namespace mixed_palletizing::simulation
