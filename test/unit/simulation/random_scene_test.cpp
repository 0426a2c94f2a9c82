// Random scenes keep what they promise.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/rectangle.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>
#include <mixed_palletizing/simulation/random_scene.hpp>

#include "analytic_rays.hpp"

namespace mixed_palletizing::simulation {
namespace {

geometry::Rectangle footprint(const SceneBox& box) {
  return {box.position_m, box.yaw_rad, box.size_m.head<2>()};
}

RandomSceneOptions smallOptions() {
  RandomSceneOptions options;
  options.scene.camera.width_px = 320;
  options.scene.camera.height_px = 200;
  return options;
}

TEST(RandomScene, KeepsItsRanges) {
  const RandomSceneOptions options = smallOptions();
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = randomScene(options, seed);
    EXPECT_TRUE(problems(scene).empty());
    const int count = static_cast<int>(scene.boxes.size());
    EXPECT_GE(count, options.boxes_min);
    EXPECT_LE(count, options.boxes_max);
    for (const SceneBox& box : scene.boxes) {
      EXPECT_TRUE((box.size_m.array() >= options.box_size_min_m.array()).all());
      EXPECT_TRUE((box.size_m.array() <= options.box_size_max_m.array()).all());
    }
    const geometry::Pose& pose = scene.camera.world_from_camera;
    const double tilt = std::acos(-pose.linear()(2, 2));
    const double distance = pose.translation().z() / std::cos(tilt);
    EXPECT_GE(tilt, options.tilt_min_rad - 1e-9);
    EXPECT_LE(tilt, options.tilt_max_rad + 1e-9);
    EXPECT_GE(distance, options.distance_min_m - 1e-9);
    EXPECT_LE(distance, options.distance_max_m + 1e-9);
  }
}

TEST(RandomScene, BoxesAreApartAndWithinTheImage) {
  const RandomSceneOptions options = smallOptions();
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = randomScene(options, seed);
    for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(geometry::distance(footprint(scene.boxes[i]), footprint(scene.boxes[j])),
                  options.gap_m - 1e-12);
      }
    }
    const Capture result = capture(scene, seed);
    for (std::size_t i = 0; i < result.mask.size(); ++i) {
      const int row = static_cast<int>(i) / scene.camera.width_px;
      const int col = static_cast<int>(i) % scene.camera.width_px;
      const bool border =
          row == 0 || col == 0 || row == scene.camera.height_px - 1 || col == scene.camera.width_px - 1;
      ASSERT_FALSE(border && result.mask[i] != 0) << row << " " << col;
    }
  }
}

TEST(RandomScene, NothingStandsBeforeTheMarker) {
  const RandomSceneOptions options = smallOptions();
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = randomScene(options, seed);
    const Eigen::Vector3d eye = scene.camera.world_from_camera.translation();
    const geometry::Pose camera_from_world = scene.camera.world_from_camera.inverse();
    for (const Eigen::Vector3d& corner : markerCorners(scene.marker)) {
      EXPECT_EQ(analytic::trace(scene, eye, corner - eye).object, 0);
      const Eigen::Vector2d image = Pinhole(scene.camera).project(camera_from_world * corner);
      EXPECT_GE(image.minCoeff(), 0.0);
      EXPECT_LE(image.x(), scene.camera.width_px - 1);
      EXPECT_LE(image.y(), scene.camera.height_px - 1);
    }
  }
}

TEST(RandomScene, ShowsTheAskedShareOfTheTops) {
  RandomSceneOptions options = smallOptions();
  options.boxes_min = options.boxes_max = 5;
  options.gap_m = 0.005;
  options.tilt_min_rad = 0.6;
  options.min_top_visibility = 0.98;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const double visibility : capture(randomScene(options, seed), seed).top_visibility) {
      EXPECT_GE(visibility, options.min_top_visibility) << "seed " << seed;
    }
  }
}

TEST(RandomScene, SameSeedSameSceneOtherSeedOther) {
  const RandomSceneOptions options = smallOptions();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene one = randomScene(options, seed);
    const Scene two = randomScene(options, seed);
    EXPECT_TRUE(one.camera.world_from_camera.matrix() == two.camera.world_from_camera.matrix());
    ASSERT_EQ(one.boxes.size(), two.boxes.size());
    for (std::size_t i = 0; i < one.boxes.size(); ++i) {
      EXPECT_EQ(one.boxes[i].size_m, two.boxes[i].size_m);
      EXPECT_EQ(one.boxes[i].position_m, two.boxes[i].position_m);
    }
    const Scene other = randomScene(options, seed + 1000);
    EXPECT_FALSE(one.camera.world_from_camera.isApprox(other.camera.world_from_camera));
  }
}

TEST(RandomScene, SaysWhenThereIsNoRoom) {
  RandomSceneOptions options = smallOptions();
  options.boxes_min = options.boxes_max = 50;
  EXPECT_THROW(randomScene(options, 1), std::runtime_error);
}

TEST(RandomScene, NamesEveryBrokenOption) {
  EXPECT_TRUE(problems(RandomSceneOptions()).empty());
  RandomSceneOptions options;
  options.boxes_min = 3;
  options.boxes_max = 2;
  options.box_size_min_m.x() = -1.0;
  options.gap_m = std::numeric_limits<double>::quiet_NaN();
  options.distance_min_m = 5.0;
  options.tilt_max_rad = 2.0;
  options.target_offset_max_m = -1.0;
  options.border_px_ratio = 0.6;
  options.min_top_visibility = 1.1;
  options.scene.camera.width_px = 0;
  EXPECT_EQ(problems(options).size(), 9u);
  EXPECT_THROW(randomScene(options, 1), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::simulation
