#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/detection_options.hpp>

namespace mixed_palletizing::adapters {
namespace {

/// The options that a tree gives; throws what the reader collected.
detection::DetectionOptions read(const std::string& yaml) {
  detection::DetectionOptions options;
  OptionReader reader(YAML::Load(yaml));
  readDetectionOptions(reader, options);
  reader.finish("options");
  return options;
}

TEST(DetectionOptionsFromYaml, keepTheDefaultOfAbsentKeys) {
  const detection::DetectionOptions defaults;
  const auto empty = read("{}");
  EXPECT_EQ(empty.plane.max_iterations, defaults.plane.max_iterations);
  EXPECT_EQ(empty.marker.dictionary, defaults.marker.dictionary);
  const auto some = read("{plane: {distance_m: 0.02}, marker: {id: 3, inverted: false}, method: thesis}");
  EXPECT_EQ(some.plane.distance_m, 0.02);
  EXPECT_EQ(some.plane.seed, defaults.plane.seed);
  EXPECT_EQ(some.marker.id, 3);
  EXPECT_FALSE(some.marker.inverted);
  EXPECT_EQ(some.method, detection::Method::kThesis);
  EXPECT_EQ(some.box.max_side_m, defaults.box.max_side_m);
}

TEST(DetectionOptionsFromYaml, holdBoardsPlanesAndRegions) {
  const auto options = read(
      "{mode: depalletize, plane: {max_planes: 3, floor: marker, remove: upright},"
      " marker: {board: [{id: 3, x_m: 0.5}, {id: 7, y_m: -0.2, yaw_rad: 1.5}]},"
      " region: {polygon_m: [0, 0, 1, 0, 1, 1], planes: [1, 0, 0, -0.5]}}");
  EXPECT_EQ(options.mode, detection::Mode::kDepalletize);
  EXPECT_EQ(options.plane.floor, detection::FloorChoice::kMarker);
  EXPECT_EQ(options.plane.remove, detection::RemovedPlanes::kUpright);
  ASSERT_EQ(options.marker.board.size(), 2u);
  EXPECT_EQ(options.marker.board[0].x_m, 0.5);
  EXPECT_EQ(options.marker.board[1].id, 7);
  EXPECT_EQ(options.marker.board[1].yaw_rad, 1.5);
  ASSERT_EQ(options.region.planes.size(), 1u);
  EXPECT_EQ(options.region.planes[0].offset, -0.5);
  try {
    read(
        "{marker: {board: [{id: 3, x: 0.5}, 4]}, plane: {floor: lowest}, region: {planes: [1, 0], polygon_m: "
        "[1]}}");
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    for (const char* key :
         {"marker.board[0].x", "marker.board[1]", "plane.max_planes", "region.planes", "region.polygon_m"}) {
      EXPECT_NE(text.find(key), std::string::npos) << key << " in: " << text;
    }
  }
}

TEST(DetectionOptionsFromYaml, reportAllMistakesAtOnce) {
  try {
    read("{plane: {distance: 0.02, seed: one}, box: {min_side_m: -1}, clusters: {min_points: 10}}");
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    for (const char* key : {"plane.distance", "plane.seed", "box.min_side_m", "clusters"}) {
      EXPECT_NE(text.find(key), std::string::npos) << key << " in: " << text;
    }
  }
}

}  // namespace
}  // namespace mixed_palletizing::adapters
