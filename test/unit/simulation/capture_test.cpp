// Geometry of captures: exact against plain arithmetic, masks, visibility, determinism.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include <mixed_palletizing/simulation/capture.hpp>

#include "analytic_rays.hpp"
#include "small_scenes.hpp"

namespace mixed_palletizing::simulation {
namespace {

TEST(Capture, AgreesWithPlainArithmetic) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = smallScene(seed);
    const Capture result = capture(scene, seed);
    const Pinhole pinhole(scene.camera);
    std::size_t differing = 0;
    for (int row = 0; row < scene.camera.height_px; ++row) {
      for (int col = 0; col < scene.camera.width_px; ++col) {
        const std::size_t i = pixelIndex(scene, row, col);
        const analytic::Hit hit = analytic::tracePixel(scene, row, col);
        if (result.mask[i] != std::max(hit.object, 0)) {
          ++differing;
          continue;
        }
        const geometry::ColoredPoint& point = result.cloud.points[i];
        ASSERT_EQ(std::isnan(point.z), hit.object < 0) << row << " " << col;
        if (hit.object < 0) continue;
        const Eigen::Vector3d expected = hit.t * pinhole.ray(col, row);
        ASSERT_NEAR(point.x, expected.x(), 2e-7) << row << " " << col;
        ASSERT_NEAR(point.y, expected.y(), 2e-7) << row << " " << col;
        ASSERT_NEAR(point.z, expected.z(), 2e-7) << row << " " << col;
      }
    }
    EXPECT_LE(static_cast<double>(differing), kEdgeRatio * static_cast<double>(result.mask.size()));
  }
}

TEST(Capture, MaskedPointsLieOnTheirBox) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = smallScene(seed);
    const Capture result = capture(scene, seed);
    std::vector<std::size_t> pixels(scene.boxes.size(), 0);
    for (std::size_t i = 0; i < result.mask.size(); ++i) {
      if (result.mask[i] == 0) continue;
      const SceneBox& box = scene.boxes.at(result.mask[i] - 1u);
      ++pixels[result.mask[i] - 1u];
      const Eigen::Vector3d local = worldFromBox(box).inverse() * worldPoint(scene, result.cloud.points[i]);
      const Eigen::Array3d outside = local.cwiseAbs().array() - 0.5 * box.size_m.array();
      ASSERT_NEAR(outside.maxCoeff(), 0.0, 1e-5) << "pixel " << i;
    }
    EXPECT_EQ(result.visible_pixels, pixels);
  }
}

/// Pixels in which the top of box `index` can be seen.
double topPixels(const Scene& scene, const Capture& result, std::size_t index) {
  const SceneBox& box = scene.boxes[index];
  double count = 0.0;
  for (std::size_t i = 0; i < result.mask.size(); ++i) {
    if (result.mask[i] != index + 1) continue;
    const double z = worldPoint(scene, result.cloud.points[i]).z();
    if (std::abs(z - box.base_z_m - box.size_m.z()) < 1e-5) count += 1.0;
  }
  return count;
}

/// The same camera with an image nine times as large around the old one, on the same grid of pixels.
Camera widened(const Camera& camera) {
  Camera wide = camera;
  wide.width_px = 3 * camera.width_px;
  wide.height_px = 3 * camera.height_px;
  wide.horizontal_fov_rad = 2.0 * std::atan(3.0 * std::tan(0.5 * camera.horizontal_fov_rad));
  return wide;
}

TEST(Capture, TopVisibilityIsTheSeenShareOfTheTopAlone) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = smallScene(seed);
    scene.has_marker = false;
    scene.camera.horizontal_fov_rad *= 0.6;  // some boxes now cross the border
    SceneBox lid;                            // and something hangs over the middle
    lid.size_m = {0.3, 0.05, 0.02};
    lid.base_z_m = 0.4;
    scene.boxes.push_back(lid);
    const Capture result = capture(scene, seed);
    for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
      Scene alone = scene;
      alone.boxes = {scene.boxes[i]};
      alone.camera = widened(scene.camera);
      const double all = topPixels(alone, capture(alone, seed), 0);
      ASSERT_GT(all, 0.0);
      EXPECT_NEAR(result.top_visibility[i], topPixels(scene, result, i) / all, 0.01) << "box " << i;
    }
  }
}

TEST(Capture, TopVisibilityOfSpecialViews) {
  Scene scene = bareFloor(1.0);
  scene.boxes.resize(3);
  scene.boxes[0].position_m = {0.0, 0.0};
  scene.boxes[1].position_m = {0.4, 0.0};  // its top is cut by the border
  scene.boxes[2].position_m = {5.0, 0.0};  // outside
  const Capture above = capture(scene, 1);
  EXPECT_GT(above.top_visibility[0], 0.995);
  EXPECT_GT(above.top_visibility[1], 0.0);
  EXPECT_LT(above.top_visibility[1], 0.9);
  EXPECT_EQ(above.top_visibility[2], 0.0);

  scene.boxes.resize(1);
  scene.boxes[0].size_m = {2.0, 2.0, 0.5};
  scene.camera.world_from_camera = lookAt({-1.5, 0.0, 0.3}, {0.0, 0.0, 0.3});  // below the top
  EXPECT_EQ(capture(scene, 1).top_visibility[0], 0.0);
  scene.camera.world_from_camera = lookAt({0.0, 0.0, 0.7}, {2.0, 0.0, 0.5});  // over it, part of it behind
  const double near = capture(scene, 1).top_visibility[0];
  EXPECT_GT(near, 0.0);
  EXPECT_LT(near, 0.1);
}

bool sameBytes(const Capture& a, const Capture& b) {
  const std::size_t bytes = a.cloud.points.size() * sizeof(geometry::ColoredPoint);
  return a.cloud.points.size() == b.cloud.points.size() &&
         std::memcmp(a.cloud.points.data(), b.cloud.points.data(), bytes) == 0 && a.mask == b.mask &&
         a.visible_pixels == b.visible_pixels && a.top_visibility == b.top_visibility;
}

TEST(Capture, SameSeedSameBytesWhateverTheThreads) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = smallScene(seed);
    scene.noise = {0.0005, true, 0.02, 0.4, 0.02};
    scene.camera.projector_m = Eigen::Vector3d(0.1, 0.0, 0.0);
    const Capture one = capture(scene, seed, 1);
    EXPECT_TRUE(sameBytes(one, capture(scene, seed, 2)));
    EXPECT_TRUE(sameBytes(one, capture(scene, seed, 5)));
    EXPECT_FALSE(sameBytes(one, capture(scene, seed + 1, 1)));
  }
}

TEST(Capture, NothingAboveTheHorizonAndBesideTheFloor) {
  Scene scene = bareFloor(1.0);
  scene.floor.size_x_m = scene.floor.size_y_m = 2.0;
  scene.camera.world_from_camera = lookAt({0.0, -3.0, 1.0}, {0.0, 0.0, 1.0});
  scene.camera.height_px = 201;
  const Capture result = capture(scene, 1);
  for (int col = 0; col < scene.camera.width_px; ++col) {
    for (int row = 0; row <= 100; ++row) {
      ASSERT_TRUE(std::isnan(result.cloud.points[pixelIndex(scene, row, col)].z));
    }
  }
  for (const geometry::ColoredPoint& point : result.cloud.points) {
    if (!std::isnan(point.z)) {
      ASSERT_LT(worldPoint(scene, point).cwiseAbs().maxCoeff(), 1.0 + 1e-6);
    }
  }
}

TEST(Capture, RefusesBrokenScenesAndThreads) {
  Scene scene = bareFloor(1.0);
  EXPECT_THROW(capture(scene, 1, 0), std::invalid_argument);
  scene.camera.width_px = 0;
  scene.noise.dropout_ratio = 2.0;
  try {
    capture(scene, 1);
    FAIL() << "a broken scene was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("camera.width_px"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("noise.dropout_ratio"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace mixed_palletizing::simulation
