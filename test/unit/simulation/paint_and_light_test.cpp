// Paint of the boxes, dark ink, and the projector's shadow.
#include <cmath>

#include <gtest/gtest.h>

#include <mixed_palletizing/simulation/capture.hpp>

#include "analytic_rays.hpp"
#include "small_scenes.hpp"

namespace mixed_palletizing::simulation {
namespace {

/// Hue of the pixel that shows a point of the world: 'r', 'g', 'b' or '-'.
char hueAt(const Scene& scene, const Capture& result, const Eigen::Vector3d& world_point) {
  const Eigen::Vector2d image =
      Pinhole(scene.camera).project(scene.camera.world_from_camera.inverse() * world_point);
  const std::uint32_t rgba = result.cloud
                                 .points[pixelIndex(scene, static_cast<int>(std::lround(image.y())),
                                                    static_cast<int>(std::lround(image.x())))]
                                 .rgba;
  const std::uint32_t red = (rgba >> 16) & 0xffu;
  const std::uint32_t green = (rgba >> 8) & 0xffu;
  const std::uint32_t blue = rgba & 0xffu;
  if (red > 2 * green && red > 2 * blue) return 'r';
  if (green > 2 * red && green > 2 * blue) return 'g';
  if (blue > 2 * red && blue > 2 * green) return 'b';
  return '-';
}

TEST(Capture, FacesAndLabelsHaveTheirColour) {
  Scene scene = bareFloor(1.0);
  scene.camera.world_from_camera = lookAt({0.3, -0.8, 0.8}, {0.0, 0.0, 0.1});
  SceneBox box;
  box.size_m = {0.4, 0.3, 0.2};
  box.rgb = 0xff0000;
  box.face_rgb[static_cast<std::size_t>(BoxFace::kPlusX)] = 0x00ff00;
  box.labels.push_back({{0.05, 0.0}, {0.1, 0.3}, 0x0000ff, true});  // a band across, down both long sides
  box.labels.push_back({{-0.15, -0.1}, {0.06, 0.10}, 0x0000ff, false});  // a label at the edge of the top
  scene.boxes = {box};
  const Capture result = capture(scene, 1);
  EXPECT_EQ(hueAt(scene, result, {-0.1, 0.1, 0.2}), 'r');      // top
  EXPECT_EQ(hueAt(scene, result, {0.2, 0.05, 0.1}), 'g');      // +x side
  EXPECT_EQ(hueAt(scene, result, {0.05, 0.0, 0.2}), 'b');      // band on the top
  EXPECT_EQ(hueAt(scene, result, {0.05, -0.15, 0.1}), 'b');    // band on the -y side
  EXPECT_EQ(hueAt(scene, result, {-0.1, -0.15, 0.1}), 'r');    // beside it
  EXPECT_EQ(hueAt(scene, result, {-0.15, -0.1, 0.2}), 'b');    // label
  EXPECT_EQ(hueAt(scene, result, {-0.15, -0.15, 0.15}), 'r');  // that does not run down
  EXPECT_EQ(hueAt(scene, result, {0.4, 0.0, 0.0}), '-');       // floor
}

TEST(Capture, DarkBandHasNoDataButKeepsTheMask) {
  Scene scene = bareFloor(1.0);
  SceneBox box;
  box.labels.push_back({{0.0, 0.0}, {0.05, 1.0}, 0x101010, true});
  scene.boxes = {box};
  const Capture with_data = capture(scene, 1);
  scene.noise.no_data_on_black = true;
  const Capture without = capture(scene, 1);
  EXPECT_EQ(with_data.mask, without.mask);
  EXPECT_EQ(with_data.top_visibility, without.top_visibility);
  for (std::size_t i = 0; i < without.mask.size(); ++i) {
    ASSERT_FALSE(std::isnan(with_data.cloud.points[i].z));
    const Eigen::Vector3d point = worldPoint(scene, with_data.cloud.points[i]);
    const bool on_band = without.mask[i] == 1 && std::abs(point.x()) <= 0.025;
    ASSERT_EQ(std::isnan(without.cloud.points[i].z), on_band) << point.transpose();
  }
}

TEST(Capture, ProjectorShadowHasNoData) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = smallScene(seed);
    const Capture lit = capture(scene, seed);
    scene.camera.projector_m = Eigen::Vector3d(0.25, 0.02, 0.0);
    const Capture shadowed = capture(scene, seed);
    const Eigen::Vector3d projector = scene.camera.world_from_camera * *scene.camera.projector_m;
    std::size_t differing = 0;
    std::size_t dark = 0;
    for (std::size_t i = 0; i < lit.mask.size(); ++i) {
      if (std::isnan(lit.cloud.points[i].z)) continue;
      const bool expected = analytic::blocked(scene, worldPoint(scene, lit.cloud.points[i]), projector);
      const bool found = std::isnan(shadowed.cloud.points[i].z);
      if (found) ++dark;
      if (found != expected) ++differing;
    }
    EXPECT_GT(dark, 0u);
    EXPECT_LE(static_cast<double>(differing), 2.0 * kEdgeRatio * static_cast<double>(lit.mask.size()));
  }
}

}  // namespace
}  // namespace mixed_palletizing::simulation
