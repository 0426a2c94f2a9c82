// Surfaces beside the floor, markers and boards on them, pictures on faces.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/aruco.hpp>
#include <opencv2/imgcodecs.hpp>

#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>

#include "marker_views.hpp"
#include "small_scenes.hpp"
#include "temporary_folder.hpp"

namespace mixed_palletizing::simulation {
namespace {

SceneSurface tiltedTable() {
  SceneSurface table;
  table.name = "table";
  table.size_m = {0.8, 0.6};
  table.thickness_m = 0.03;
  table.world_from_surface = poseFromRollPitchYaw({0.05, -0.03, 0.4}, {0.1, -0.15, 0.4});
  return table;
}

TEST(Surfaces, PointsLieOnThePlaneAndAreNoThing) {
  Scene scene = bareFloor(1.6);
  scene.surfaces = {tiltedTable()};
  const Capture result = capture(scene, 1);
  std::size_t on_table = 0;
  for (std::size_t i = 0; i < result.mask.size(); ++i) {
    ASSERT_EQ(result.mask[i], 0);
    const Eigen::Vector3d world = worldPoint(scene, result.cloud.points[i]);
    if (std::abs(world.z()) < 1e-5) continue;  // the floor
    const Eigen::Vector3d own = scene.surfaces[0].world_from_surface.inverse() * world;
    const bool inside = std::abs(own.x()) < 0.4 + 1e-5 && std::abs(own.y()) < 0.3 + 1e-5;
    ASSERT_TRUE(inside && own.z() < 1e-5 && own.z() > -0.03 - 1e-5) << own.transpose();
    on_table += std::abs(own.z()) < 1e-5 ? 1 : 0;
  }
  EXPECT_GT(on_table, 5000u);
}

TEST(Surfaces, ASheetIsSeenFromBothSides) {
  Scene scene = bareFloor(1.6);
  scene.surfaces = {tiltedTable()};
  scene.surfaces[0].thickness_m = 0.0;
  for (const double roll : {0.0, 3.14159265358979}) {
    scene.surfaces[0].world_from_surface = poseFromRollPitchYaw({0.0, 0.0, 0.4}, {roll, 0.0, 0.0});
    const Capture result = capture(scene, 1);
    EXPECT_NEAR(result.cloud.points[pixelIndex(scene, 100, 160)].z, 1.2, 1e-6);
  }
}

/// Largest distance [px] between found corners and those of the marker.
double distanceOf(const std::vector<cv::Point2f>& corners, const Scene& scene, const Marker& marker) {
  const geometry::Pose camera_from_world = scene.camera.world_from_camera.inverse();
  const std::array<Eigen::Vector3d, 4> expected = markerCorners(marker);
  double distance = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d world = worldFromSurface(scene, marker.surface) * expected[i];
    const Eigen::Vector2d image = Pinhole(scene.camera).project(camera_from_world * world);
    distance = std::max(distance, (Eigen::Vector2d(corners[i].x, corners[i].y) - image).norm());
  }
  return distance;
}

/// Every marker is found where the truth puts it. (OpenCV may also take the outline of the paper for a marker.)
void expectMarkers(const Scene& scene, bool inverted, const std::vector<Marker>& markers) {
  const FoundMarkers found = findMarkers(capture(scene, 1), cv::aruco::DICT_4X4_50, inverted);
  for (const Marker& marker : markers) {
    double nearest = 1e9;
    for (std::size_t i = 0; i < found.ids.size(); ++i) {
      if (found.ids[i] == marker.id) nearest = std::min(nearest, distanceOf(found.corners[i], scene, marker));
    }
    EXPECT_LT(nearest, 1.0) << "marker " << marker.id;
  }
}

TEST(Surfaces, MarkersAreFoundWhereTheyLie) {
  for (const bool inverted : {true, false}) {
    SCOPED_TRACE(inverted ? "inverted" : "normal");
    Scene scene = bareFloor(1.5, 1280);
    scene.camera.world_from_camera = lookAt({0.1, -0.7, 1.5}, {0.05, 0.0, 0.4});
    scene.surfaces = {tiltedTable()};
    scene.markers.resize(3);
    for (int i = 0; i < 3; ++i) {
      Marker& marker = scene.markers[static_cast<std::size_t>(i)];
      marker.id = i + 3;
      marker.side_m = 0.1;
      marker.inverted = inverted;
      marker.surface = "table";
      marker.position_m = {-0.2 + 0.2 * i, 0.1 * i - 0.1};
      marker.yaw_rad = i;
    }
    expectMarkers(scene, inverted, scene.markers);
  }
}

TEST(Surfaces, EveryMarkerOfABoardIsFound) {
  for (const bool inverted : {true, false}) {
    SCOPED_TRACE(inverted ? "inverted" : "normal");
    Scene scene = bareFloor(1.2, 1280);
    scene.camera.world_from_camera = lookAt({0.2, -0.5, 1.1}, {0.0, 0.0, 0.0});
    MarkerBoard board;
    board.first.id = 7;
    board.first.side_m = 0.08;
    board.first.inverted = inverted;
    board.first.yaw_rad = 0.3;
    board.first.position_m = {0.02, -0.01};
    scene.boards = {board};
    const std::vector<Marker> markers = markersOf(board);
    ASSERT_EQ(markers.size(), 12u);
    expectMarkers(scene, inverted, markers);
  }
}

class Textures : public TemporaryFolder {
 protected:
  /// Four colours: red, green above blue, white.
  std::shared_ptr<const Texture> fourColors() const {
    cv::Mat picture(100, 200, CV_8UC3);
    picture(cv::Rect(0, 0, 100, 50)).setTo(cv::Scalar(0, 0, 255));
    picture(cv::Rect(100, 0, 100, 50)).setTo(cv::Scalar(0, 255, 0));
    picture(cv::Rect(0, 50, 100, 50)).setTo(cv::Scalar(255, 0, 0));
    picture(cv::Rect(100, 50, 100, 50)).setTo(cv::Scalar(255, 255, 255));
    cv::imwrite(path("four.png"), picture);
    return loadTexture(path("four.png"));
  }
};

/// Hue of the pixel that shows a point of the world: 'r', 'g', 'b', 'w'.
char hueAt(const Scene& scene, const Capture& result, const Eigen::Vector3d& world_point) {
  const Eigen::Vector2d image =
      Pinhole(scene.camera).project(scene.camera.world_from_camera.inverse() * world_point);
  const std::size_t i =
      pixelIndex(scene, static_cast<int>(std::lround(image.y())), static_cast<int>(std::lround(image.x())));
  const std::uint32_t rgba = result.cloud.points[i].rgba;
  const std::uint32_t red = (rgba >> 16) & 0xffu;
  const std::uint32_t green = (rgba >> 8) & 0xffu;
  const std::uint32_t blue = rgba & 0xffu;
  if (red > 2 * green) return 'r';
  if (green > 2 * blue) return 'g';
  return blue > 2 * red ? 'b' : 'w';
}

TEST_F(Textures, LieUprightOnTheFaces) {
  Scene scene = bareFloor(1.0);
  SceneBox box;
  box.size_m = {0.2, 0.2, 0.2};
  box.face_texture.fill(fourColors());
  scene.boxes = {box};
  const auto look = [&](const Eigen::Vector3d& eye, const Eigen::Vector3d& middle,
                        const Eigen::Vector3d& right, const Eigen::Vector3d& up) {
    scene.camera.world_from_camera = lookAt(eye, {0.0, 0.0, 0.1});
    const Capture result = capture(scene, 1);
    EXPECT_EQ(hueAt(scene, result, middle - 0.05 * right + 0.05 * up), 'r');
    EXPECT_EQ(hueAt(scene, result, middle + 0.05 * right + 0.05 * up), 'g');
    EXPECT_EQ(hueAt(scene, result, middle - 0.05 * right - 0.05 * up), 'b');
    EXPECT_EQ(hueAt(scene, result, middle + 0.05 * right - 0.05 * up), 'w');
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  look({0, 0, 1}, 0.2 * z, x, y);
  look({0.1, -1, 0.3}, 0.1 * z - 0.1 * y, x, z);
  look({0.1, 1, 0.3}, 0.1 * z + 0.1 * y, -x, z);
  look({-1, 0.1, 0.3}, 0.1 * z - 0.1 * x, -y, z);
  look({1, 0.1, 0.3}, 0.1 * z + 0.1 * x, y, z);
}

TEST_F(Textures, LieOnSurfacesAndTheFloor) {
  Scene scene = bareFloor(1.6);
  scene.floor.texture = fourColors();
  scene.surfaces = {tiltedTable()};
  scene.surfaces[0].texture = scene.floor.texture;
  const Capture result = capture(scene, 1);
  const geometry::Pose& pose = scene.surfaces[0].world_from_surface;
  EXPECT_EQ(hueAt(scene, result, pose * Eigen::Vector3d(-0.1, 0.1, 0)), 'r');
  EXPECT_EQ(hueAt(scene, result, pose * Eigen::Vector3d(0.1, 0.1, 0)), 'g');
  EXPECT_EQ(hueAt(scene, result, pose * Eigen::Vector3d(-0.1, -0.1, 0)), 'b');
  EXPECT_EQ(hueAt(scene, result, {0.54, -0.3, 0.0}), 'w');
}

TEST_F(Textures, UnreadableOnesAreSaid) {
  EXPECT_THROW(loadTexture(path("none.png")), std::runtime_error);
  EXPECT_THROW(loadTexture(write("text.png", "no picture")), std::runtime_error);
}

}  // namespace
}  // namespace mixed_palletizing::simulation
