// The marker's picture: OpenCV finds it in the colour channel, its corners where the truth says.
#include <cmath>

#include <gtest/gtest.h>

#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>

#include "marker_views.hpp"
#include "small_scenes.hpp"

namespace mixed_palletizing::simulation {
namespace {

void expectMarker(const Scene& scene, int dictionary) {
  const FoundMarkers found = findMarkers(capture(scene, 1), dictionary, scene.marker.inverted);
  ASSERT_EQ(found.ids, std::vector<int>{scene.marker.id});
  const std::array<Eigen::Vector3d, 4> corners = markerCorners(scene.marker);
  const geometry::Pose camera_from_world = scene.camera.world_from_camera.inverse();
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d expected = Pinhole(scene.camera).project(camera_from_world * corners[i]);
    EXPECT_NEAR(found.corners[0][i].x, expected.x(), 0.5) << "corner " << i;
    EXPECT_NEAR(found.corners[0][i].y, expected.y(), 0.5) << "corner " << i;
  }
}

TEST(Marker, IsFoundWhereItIs) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const bool inverted : {true, false}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + (inverted ? " inverted" : " normal"));
      Scene scene = smallScene(seed, 960);
      scene.marker.inverted = inverted;
      // OpenCV takes the outline of narrow white paper and the marker's border for one (minMarkerDistanceRate).
      if (!inverted) scene.marker.quiet_zone_m = 0.04;
      expectMarker(scene, cv::aruco::DICT_4X4_50);
    }
  }
}

TEST(Marker, OfOtherDictionariesPlacedElsewhere) {
  Scene scene = bareFloor(1.0, 960);
  scene.has_marker = true;
  scene.marker.position_m = {0.08, -0.05};
  scene.marker.yaw_rad = 2.0;
  scene.marker.id = 12;
  for (const bool inverted : {true, false}) {
    scene.marker.inverted = inverted;
    scene.marker.dictionary = "DICT_5X5_1000";
    expectMarker(scene, cv::aruco::DICT_5X5_1000);
    scene.marker.dictionary = "DICT_6X6_250";
    expectMarker(scene, cv::aruco::DICT_6X6_250);
    scene.marker.dictionary = "DICT_APRILTAG_36h11";
    expectMarker(scene, cv::aruco::DICT_APRILTAG_36h11);
  }
}

TEST(Marker, BlackInkHasNoDataByOption) {
  for (const bool inverted : {true, false}) {
    Scene scene = bareFloor(1.0);
    scene.has_marker = true;
    scene.marker.inverted = inverted;
    scene.noise.no_data_on_black = true;
    const Capture result = capture(scene, 1);
    const geometry::Pose camera_from_world = scene.camera.world_from_camera.inverse();
    const auto hasData = [&](double x, double y) {
      const Eigen::Vector2d image =
          Pinhole(scene.camera).project(camera_from_world * Eigen::Vector3d(x, y, 0.0));
      return !std::isnan(result.cloud
                             .points[pixelIndex(scene, static_cast<int>(std::lround(image.y())),
                                                static_cast<int>(std::lround(image.x())))]
                             .z);
    };
    const double half = 0.5 * scene.marker.side_m;
    EXPECT_EQ(hasData(half - 0.01, 0.0), inverted);   // border
    EXPECT_EQ(hasData(half + 0.01, 0.0), !inverted);  // quiet zone
    EXPECT_TRUE(hasData(half + 0.05, 0.0));           // floor
  }
}

TEST(Marker, CornersGoAroundAsOpenCvOrdersThem) {
  Marker marker;
  marker.side_m = 0.2;
  marker.position_m = {1.0, 2.0};
  marker.yaw_rad = 0.3;
  const std::array<Eigen::Vector3d, 4> corners = markerCorners(marker);
  const geometry::Pose world_from_marker = worldFromMarker(marker);
  EXPECT_TRUE((corners[1] - corners[0]).isApprox(0.2 * world_from_marker.linear().col(0)));
  EXPECT_TRUE((corners[0] - corners[3]).isApprox(0.2 * world_from_marker.linear().col(1)));
  EXPECT_TRUE(
      (0.25 * (corners[0] + corners[1] + corners[2] + corners[3])).isApprox(Eigen::Vector3d(1, 2, 0)));
}

}  // namespace
}  // namespace mixed_palletizing::simulation
