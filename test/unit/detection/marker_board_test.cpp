// Several markers, faint pictures, and floors that are not the largest plane.
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <mixed_palletizing/detection/base_frame.hpp>

#include "marker_dictionary.hpp"
#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

using simulation::Scene;

/// The scene's marker and nothing else, seen from a place drawn from the seed.
Scene emptyScene(std::uint64_t seed) {
  auto recipe = test::sceneRecipe(0.0001, 960, 600);
  recipe.groups.clear();
  recipe.view.tilt_rad.max = 0.6;
  recipe.view.target_offset_m.max = 0.02;  // the markers painted around it stay in the image
  recipe.scene.marker.side_m = 0.12;
  return simulation::recipeScene(recipe, seed, 0);
}

/// Paints a marker, white on black, onto the floor of a cloud.
void paintMarker(const geometry::Pose& base_from_camera, const BoardMarker& place, double side_m,
                 geometry::OrganizedCloud& cloud) {
  const std::vector<bool> white = markerCells("DICT_4X4_50", place.id);
  constexpr int kCells = 6;
  for (geometry::ColoredPoint& point : cloud.points) {
    const Eigen::Vector3d p = base_from_camera * Eigen::Vector3f(point.x, point.y, point.z).cast<double>();
    if (!p.allFinite() || std::abs(p.z()) > 0.002) continue;
    const Eigen::Vector2d q =
        Eigen::Rotation2Dd(-place.yaw_rad) * (p.head<2>() - Eigen::Vector2d(place.x_m, place.y_m));
    const int col = static_cast<int>(std::floor((q.x() / side_m + 0.5) * kCells));
    const int row = static_cast<int>(std::floor((0.5 - q.y() / side_m) * kCells));
    if (std::min(row, col) < -1 || std::max(row, col) > kCells) continue;
    const bool in_picture = std::min(row, col) >= 0 && std::max(row, col) < kCells;
    const bool black = in_picture && white[static_cast<std::size_t>(row * kCells + col)];
    point.rgba = black || !in_picture ? 0xff101010u : 0xfff0f0f0u;
  }
}

double originError(const BaseFrame& frame, const geometry::Pose& truth) {
  return (frame.base_from_camera.inverse().translation() - truth.inverse().translation()).norm();
}

double angleError(const BaseFrame& frame, const geometry::Pose& truth) {
  return std::abs(Eigen::AngleAxisd(frame.base_from_camera.linear() * truth.linear().transpose()).angle());
}

TEST(MarkerBoard, fitsAllSeenMarkersJointly) {
  for (std::uint64_t seed = 620; seed < 623; ++seed) {
    const Scene scene = emptyScene(seed);
    auto cloud = simulation::capture(scene, seed).cloud;
    const geometry::Pose truth = test::trueBaseFromCamera(scene);
    DetectionOptions options;
    options.marker.board.push_back({0, 0.0, 0.0, 0.0});
    options.marker.board.push_back({3, 0.22, 0.05, 0.7});
    options.marker.board.push_back({7, -0.20, -0.04, -1.9});
    options.marker.board.push_back({9, 3.0, 0.0, 0.0});  // outside of the image
    for (std::size_t i = 1; i < 3; ++i) paintMarker(truth, options.marker.board[i], 0.10, cloud);
    const auto result = findBaseFrame(cloud.view(), BaseFrameSource::kMarker, options);
    ASSERT_TRUE(result.frame) << result.message << ", seed " << seed;
    EXPECT_EQ(result.frame->markers_used, 3u) << "seed " << seed;
    EXPECT_LT(originError(*result.frame, truth), 0.0003) << "seed " << seed;
    EXPECT_LT(angleError(*result.frame, truth), 0.0005) << "seed " << seed;
    EXPECT_LT(result.frame->board_rms_m, 0.0005) << "seed " << seed;

    options.marker.board[1].x_m += 0.03;
    const auto wrong = findBaseFrame(cloud.view(), BaseFrameSource::kMarker, options);
    EXPECT_FALSE(wrong.frame);
    EXPECT_NE(wrong.message.find("from its place on the board"), std::string::npos) << wrong.message;
  }
}

TEST(FindBaseFrame, readsAnUnderexposedPicture) {
  const Scene scene = emptyScene(631);
  auto cloud = simulation::capture(scene, 631).cloud;
  for (geometry::ColoredPoint& point : cloud.points) {
    std::uint32_t dim = 0xff000000u;
    for (int shift = 0; shift < 24; shift += 8) dim |= (10u + ((point.rgba >> shift) & 0xffu) / 8u) << shift;
    point.rgba = dim;
  }
  const auto result = findBaseFrame(cloud.view(), BaseFrameSource::kMarker, DetectionOptions());
  ASSERT_TRUE(result.frame) << result.message;
  EXPECT_LT(originError(*result.frame, test::trueBaseFromCamera(scene)), 0.0003);
}

TEST(FindBaseFrame, refusesAMarkerOfAnotherSize) {
  const Scene scene = emptyScene(632);
  const auto cloud = simulation::capture(scene, 632).cloud;
  DetectionOptions options;
  options.marker.side_m = 0.12;
  EXPECT_TRUE(findBaseFrame(cloud.view(), BaseFrameSource::kMarker, options).frame);
  options.marker.side_m = 0.15;
  EXPECT_FALSE(findBaseFrame(cloud.view(), BaseFrameSource::kMarker, options).frame);
}

TEST(FindBaseFrame, choosesTheFloorAmongPlanes) {
  // A top larger than the floor that is left in view, and the marker beside it on the floor.
  Scene scene = emptyScene(633);
  scene.camera.world_from_camera = simulation::lookAt({0.0, -0.2, 1.9}, {0.35, 0.0, 0.0});
  simulation::SceneBox table;
  table.size_m = {0.9, 1.2, 0.3};
  table.position_m = {0.62, 0.0};
  scene.boxes = {table};
  scene.marker.position_m = {0.0, 0.0};
  const auto cloud = simulation::capture(scene, 633).cloud;
  const geometry::Pose truth = test::trueBaseFromCamera(scene);
  DetectionOptions options;
  const auto top = findBaseFrame(cloud.view(), BaseFrameSource::kFloor, options);
  ASSERT_TRUE(top.frame);
  EXPECT_NEAR(top.frame->base_from_camera.translation().z(), 1.6, 0.01)
      << "the table's top is the largest plane";
  options.plane.max_planes = 3;
  for (const FloorChoice choice : {FloorChoice::kLowest, FloorChoice::kCameraHeight, FloorChoice::kMarker}) {
    options.plane.floor = choice;
    options.plane.camera_height_m = 1.85;
    const auto found = findBaseFrame(cloud.view(), BaseFrameSource::kMarker, options);
    ASSERT_TRUE(found.frame) << found.message;
    EXPECT_LT(originError(*found.frame, truth), 0.0005);
    ASSERT_FALSE(found.frame->planes.empty());
    EXPECT_NEAR(found.frame->planes.front().base_from_plane.translation().z(), 0.3, 0.001);
    EXPECT_NEAR(found.frame->planes.front().base_from_plane.linear().determinant(), 1.0, 1e-9);
    EXPECT_EQ(removedPlanes(*found.frame, RemovedPlanes::kNone).size(), 0u);
    EXPECT_EQ(removedPlanes(*found.frame, RemovedPlanes::kAll).size(), found.frame->planes.size());
  }
}

}  // namespace
}  // namespace mixed_palletizing::detection
