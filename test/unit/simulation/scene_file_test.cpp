// Scene files: every shipped one loads, every key arrives, every mistake is named with its line.
#include <cmath>
#include <random>

#include <mixed_palletizing/simulation/scene_file.hpp>

#include "temporary_folder.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

std::vector<std::string> shippedScenes() {
  std::vector<std::string> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(MIXED_PALLETIZING_SOURCE_DIR "/config/scenes")) {
    paths.push_back(entry.path().string());
  }
  return paths;
}

TEST(ShippedScenes, Load) {
  const std::vector<std::string> paths = shippedScenes();
  EXPECT_GE(paths.size(), 5u);
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    EXPECT_NO_THROW(EXPECT_TRUE(warnings(loadScene(path)).empty()));
  }
  const Scene boxes = loadScene(MIXED_PALLETIZING_SOURCE_DIR "/config/scenes/three_boxes.yaml");
  const Scene empty = loadScene(MIXED_PALLETIZING_SOURCE_DIR "/config/scenes/calibration.yaml");
  EXPECT_EQ(boxes.boxes.size(), 3u);
  EXPECT_TRUE(boxes.marker.inverted);
  EXPECT_TRUE(empty.boxes.empty());
  EXPECT_TRUE(boxes.camera.world_from_camera.isApprox(empty.camera.world_from_camera));
}

class SceneFile : public TemporaryFolder {
 protected:
  Scene load(const std::string& text) const { return loadScene(write("scene.yaml", text)); }

  /// Message of the error; empty when the text is a scene.
  std::string errorOf(const std::string& text) const {
    try {
      load(text);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  }

  void expectError(const std::string& text, int line, const std::string& mistake) const {
    const std::string expected = path("scene.yaml") + ":" + std::to_string(line) + ": " + mistake;
    EXPECT_NE(errorOf(text).find(expected), std::string::npos)
        << "not '" << expected << "' but '" << errorOf(text) << "'";
  }
};

const std::string kCamera = "camera: {eye_m: [0, 0, 1], target_m: [0, 0, 0]}\n";

TEST_F(SceneFile, AbsentKeysKeepTheirDefaults) {
  const Scene scene = load(kCamera);
  const Scene defaults;
  EXPECT_EQ(scene.has_marker, defaults.has_marker);
  EXPECT_EQ(scene.marker.dictionary, defaults.marker.dictionary);
  EXPECT_EQ(scene.floor.rgb, defaults.floor.rgb);
  EXPECT_EQ(scene.camera.width_px, defaults.camera.width_px);
  EXPECT_FALSE(scene.camera.projector_m.has_value());
  EXPECT_TRUE(scene.boxes.empty());
  EXPECT_EQ(scene.noise.depth_stddev_at_1m_m, 0.0);
}

TEST_F(SceneFile, EveryKeyArrives) {
  const Scene scene = load(R"(
floor: {size_m: [5, 6], rgb: 0x010203}
marker: {dictionary: DICT_6X6_250, id: 3, side_m: 0.2, quiet_zone_m: 0.01, inverted: false, position_m: [1, 2], yaw_deg: 90}
camera:
  width_px: 640
  height_px: 480
  horizontal_fov_deg: 60
  world_from_camera: [[1, 0, 0, 0.1], [0, -1, 0, 0.2], [0, 0, -1, 1.3], [0, 0, 0, 1]]
  projector_m: [0.1, 0.02, 0.03]
boxes:
  - {name: a, size_m: [0.3, 0.2, 0.1], position_m: [0.1, 0.2], base_z_m: 0.05, yaw_deg: -45, rgb: 0xaabbcc}
  - size_m: [0.1, 0.1, 0.1]
    position_m: [1, 1]
    face_rgb: {top: 0x111111, bottom: 0x222222, minus_x: 0x333333, plus_x: 0x444444, minus_y: 0x555555, plus_y: 0x666666}
    labels:
      - {center_m: [0.01, 0.02], size_m: [0.03, 0.04], rgb: 0x000001, down_sides: true}
      - {}
    shape:
      bulge_m: 0.004
      rounding_m: 0.003
      dents: [{center_m: [0.01, 0.02], radius_m: 0.03, depth_m: 0.005}]
      flaps: [{side: minus_y, length_m: 0.05, angle_deg: 90}, {}]
noise: {depth_stddev_at_1m_m: 0.001, no_data_on_black: true, dropout_ratio: 0.1, flying_pixel_ratio: 0.2, depth_edge_m: 0.03,
        dark_noise_gain: 2, grazing_noise_gain: 3}
)");
  EXPECT_EQ(scene.floor.size_y_m, 6.0);
  EXPECT_EQ(scene.floor.rgb, 0x010203u);
  EXPECT_EQ(scene.marker.dictionary, "DICT_6X6_250");
  EXPECT_EQ(scene.marker.id, 3);
  EXPECT_EQ(scene.marker.side_m, 0.2);
  EXPECT_EQ(scene.marker.quiet_zone_m, 0.01);
  EXPECT_FALSE(scene.marker.inverted);
  EXPECT_EQ(scene.marker.position_m, Eigen::Vector2d(1, 2));
  EXPECT_NEAR(scene.marker.yaw_rad, 90 * kRadPerDeg, 1e-12);
  EXPECT_EQ(scene.camera.width_px, 640);
  EXPECT_EQ(scene.camera.height_px, 480);
  EXPECT_NEAR(scene.camera.horizontal_fov_rad, 60 * kRadPerDeg, 1e-12);
  EXPECT_EQ(scene.camera.world_from_camera.translation(), Eigen::Vector3d(0.1, 0.2, 1.3));
  EXPECT_EQ(scene.camera.world_from_camera.linear()(1, 1), -1.0);
  EXPECT_EQ(scene.camera.projector_m, Eigen::Vector3d(0.1, 0.02, 0.03));
  ASSERT_EQ(scene.boxes.size(), 2u);
  EXPECT_EQ(scene.boxes[0].name, "a");
  EXPECT_EQ(scene.boxes[0].size_m, Eigen::Vector3d(0.3, 0.2, 0.1));
  EXPECT_EQ(scene.boxes[0].position_m, Eigen::Vector2d(0.1, 0.2));
  EXPECT_EQ(scene.boxes[0].base_z_m, 0.05);
  EXPECT_NEAR(scene.boxes[0].yaw_rad, -45 * kRadPerDeg, 1e-12);
  EXPECT_EQ(scene.boxes[0].rgb, 0xaabbccu);
  const auto face = [&](BoxFace which) {
    return scene.boxes[1].face_rgb[static_cast<std::size_t>(which)].value();
  };
  EXPECT_EQ(face(BoxFace::kTop), 0x111111u);
  EXPECT_EQ(face(BoxFace::kBottom), 0x222222u);
  EXPECT_EQ(face(BoxFace::kMinusX), 0x333333u);
  EXPECT_EQ(face(BoxFace::kPlusX), 0x444444u);
  EXPECT_EQ(face(BoxFace::kMinusY), 0x555555u);
  EXPECT_EQ(face(BoxFace::kPlusY), 0x666666u);
  ASSERT_EQ(scene.boxes[1].labels.size(), 2u);
  EXPECT_EQ(scene.boxes[1].labels[0].center_m, Eigen::Vector2d(0.01, 0.02));
  EXPECT_EQ(scene.boxes[1].labels[0].size_m, Eigen::Vector2d(0.03, 0.04));
  EXPECT_EQ(scene.boxes[1].labels[0].rgb, 1u);
  EXPECT_TRUE(scene.boxes[1].labels[0].down_sides);
  EXPECT_EQ(scene.noise.depth_stddev_at_1m_m, 0.001);
  EXPECT_TRUE(scene.noise.no_data_on_black);
  EXPECT_EQ(scene.noise.dropout_ratio, 0.1);
  EXPECT_EQ(scene.noise.flying_pixel_ratio, 0.2);
  EXPECT_EQ(scene.noise.depth_edge_m, 0.03);
  EXPECT_EQ(scene.noise.dark_noise_gain, 2.0);
  EXPECT_EQ(scene.noise.grazing_noise_gain, 3.0);
  const BoxShape& shape = scene.boxes[1].shape;
  EXPECT_EQ(shape.bulge_m, 0.004);
  EXPECT_EQ(shape.rounding_m, 0.003);
  ASSERT_EQ(shape.dents.size(), 1u);
  EXPECT_EQ(shape.dents[0].center_m, Eigen::Vector2d(0.01, 0.02));
  EXPECT_EQ(shape.dents[0].radius_m, 0.03);
  EXPECT_EQ(shape.dents[0].depth_m, 0.005);
  ASSERT_EQ(shape.flaps.size(), 2u);
  EXPECT_EQ(shape.flaps[0].side, BoxFace::kMinusY);
  EXPECT_EQ(shape.flaps[0].length_m, 0.05);
  EXPECT_NEAR(shape.flaps[0].angle_rad, 90 * kRadPerDeg, 1e-12);
  EXPECT_EQ(shape.flaps[1].side, BoxFace::kPlusX);
}

TEST_F(SceneFile, WithoutMarker) { EXPECT_FALSE(load("marker: none\n" + kCamera).has_marker); }

TEST_F(SceneFile, MistakesAreNamedWithFileLineAndKey) {
  expectError(kCamera + "boxs: []\n", 2, "boxs: is no known key");
  expectError(kCamera + "noise:\n  dropout: 0.1\n", 3, "noise.dropout: is no known key");
  expectError(kCamera + "boxes:\n  - {}\n  - size_m: [1, 2]\n", 4,
              "boxes[1].size_m: is no list of 3 finite numbers");
  expectError(kCamera + "boxes:\n  - size_m: [1, 2, .nan]\n", 3,
              "boxes[0].size_m: is no list of 3 finite numbers");
  expectError(kCamera + "boxes:\n  - yaw_deg: left\n", 3, "boxes[0].yaw_deg: is no finite number");
  expectError(kCamera + "boxes:\n  - yaw_deg: .inf\n", 3, "boxes[0].yaw_deg: is no finite number");
  expectError(kCamera + "boxes:\n  - shape:\n      flaps:\n        - side: top\n", 5,
              "boxes[0].shape.flaps[0].side: 'top' is none of");
  expectError(kCamera + "boxes: 3\n", 2, "boxes: is no list");
  expectError(kCamera + "boxes: [3]\n", 2, "boxes[0]: is no map");
  expectError(kCamera + "marker: nothing\n", 2, "marker: is no map");
  expectError(kCamera + "marker:\n  id: 1.5\n", 3, "marker.id: '1.5' is no integer");
  expectError(kCamera + "marker:\n  inverted: perhaps\n", 3,
              "marker.inverted: 'perhaps' is no true or false");
  expectError(kCamera + "floor:\n  rgb: red\n", 3, "floor.rgb: 'red' is no colour 0xRRGGBB");
  expectError(kCamera + "floor:\n  rgb: 1\n  rgb: 2\n", 4, "floor.rgb: given twice");
  expectError("camera:\n  eye_m: [0, 0, 1]\n", 1, "camera.pose: give either eye_m and target_m");
  expectError("camera:\n  eye_m: [0, 0, 1]\n  target_m: [0, 0, 1]\n", 2, "camera.eye_m: is the same point");
  expectError("camera:\n  world_from_camera: [1, 2]\n", 2, "camera.world_from_camera: is no list of 4 rows");
  expectError("floor: {}\n", 1, "camera.pose: give either eye_m and target_m");
  expectError("", 1, "camera.pose: give either eye_m and target_m");
  expectError("[1, 2]\n", 1, "file: is no map");
  expectError("floor:\n  - a\n b: c\n", 3, "no YAML: ");
}

TEST_F(SceneFile, BrokenRulesAreNamedWithTheirLine) {
  expectError(kCamera + "noise:\n  depth_stddev_at_1m_m: 5\n", 3, "noise.depth_stddev_at_1m_m: 5 is not in");
  expectError(kCamera + "boxes:\n  - name: a\n    yaw_deg: 10\n    size_m: [300, 200, 100]\n", 5,
              "boxes[0].size_m: 300 200 100 are not lengths");
  expectError(kCamera + "boxes:\n  - {name: a}\n  - {name: b}\n", 4, "boxes[1]: overlaps boxes[0]");
  expectError("camera:\n  eye_m: [0, 0, 1]\n  target_m: [0, 0, 0]\n  horizontal_fov_deg: 200\n", 4,
              "camera.horizontal_fov: 200 is not in");
}

TEST_F(SceneFile, AllMistakesAtOnceInTheOrderOfTheFile) {
  const std::string error = errorOf("floor: {rgb: x}\n" + kCamera + "noise: {a: 1, b: 2}\n");
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 2) << error;
  EXPECT_LT(error.find("floor.rgb"), error.find("noise.a")) << error;
}

TEST_F(SceneFile, UnreadableFilesAreSaid) {
  EXPECT_THROW(loadScene(path("missing.yaml")), std::runtime_error);
  EXPECT_THROW(loadScene(path("")), std::runtime_error);  // a folder
}

TEST_F(SceneFile, DamagedFilesNeverDoAnythingElse) {
  std::vector<std::string> wholes;
  for (const std::string& shipped : shippedScenes()) wholes.push_back(read(shipped));
  for (std::uint32_t seed = 1; seed <= 1000; ++seed) {
    std::mt19937 random(seed);
    std::string text = wholes[seed % wholes.size()];
    for (int i = 0; i < 3; ++i) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) text[at] = "0123456789.,:-[]{}\n \"'&*!#%@\x01\xff"[random() % 29];
      if (random() % 2 == 0) text.erase(at, random() % 30);
    }
    try {
      load(text);
    } catch (const std::invalid_argument&) {  // the only kind of error allowed for a readable file
    } catch (const std::exception& error) {
      FAIL() << "seed " << seed << ": " << error.what();
    }
  }
}

}  // namespace
}  // namespace mixed_palletizing::simulation
