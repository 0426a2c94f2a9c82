// The tool detect_boxes, run as a user runs it, on a simulated cloud from a file and from a bag.
#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <mixed_palletizing/adapters/calibration_file.hpp>
#include <mixed_palletizing/adapters/cloud_bag.hpp>
#include <mixed_palletizing/adapters/cloud_files.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

#include "recorded_data.hpp"
#include "tool_fixture.hpp"

namespace mixed_palletizing {
namespace {

class DetectBoxes : public test::ToolFixture {
 protected:
  DetectBoxes() : ToolFixture(DETECT_BOXES_TOOL) {}
  void SetUp() override {
    simulation::Recipe recipe;
    recipe.groups.front().count = {2, 2};
    recipe.scene.camera.width_px = 640;
    recipe.scene.camera.height_px = 400;
    recipe.scene.noise.depth_stddev_at_1m_m = 0.0003;
    recipe.scene.noise.no_data_on_black = true;
    scene_ = simulation::recipeScene(recipe, 77, 0);
    adapters::writeCloud(path("c.pcd"), simulation::capture(scene_, 77).cloud);
  }

  nlohmann::json detect(const std::string& arguments) const {
    EXPECT_EQ(run(arguments + " --json " + path("d.json")), 0) << read("err.txt");
    return nlohmann::json::parse(read("d.json"), nullptr, false);
  }

  /// Both boxes of the scene are among those of the file, to a millimetre.
  void expectTheScene(const nlohmann::json& json) const {
    ASSERT_EQ(json.at("boxes").size(), 2u);
    for (const simulation::SceneBox& truth : scene_.boxes) {
      const bool found =
          std::any_of(json.at("boxes").begin(), json.at("boxes").end(), [&](const nlohmann::json& box) {
            return std::abs(box.at("size")[0].get<double>() - truth.size_m.head<2>().maxCoeff()) < 0.001 &&
                   std::abs(box.at("size")[1].get<double>() - truth.size_m.head<2>().minCoeff()) < 0.001 &&
                   std::abs(box.at("size")[2].get<double>() - truth.size_m.z()) < 0.001 &&
                   std::abs(box.at("center")[0].get<double>() - truth.position_m.x()) < 0.001 &&
                   std::abs(box.at("center")[1].get<double>() - truth.position_m.y()) < 0.001;
          });
      EXPECT_TRUE(found) << json.dump(1);
    }
  }

  simulation::Scene scene_;
};

TEST_F(DetectBoxes, findsTheSceneWithEverySourceOfCloudAndBaseFrame) {
  const nlohmann::json by_marker = detect("--cloud " + path("c.pcd") + " --repeat 3");
  expectTheScene(by_marker);
  EXPECT_GT(by_marker.at("timings_ms").at("total").get<double>(), 0.0);
  EXPECT_GT(by_marker.at("timings_ms").size(), 3u);

  adapters::Calibration calibration;
  calibration.base_from_camera = scene_.camera.world_from_camera;
  adapters::writeCalibration(path("base.yaml"), calibration);
  expectTheScene(detect("--cloud " + path("c.pcd") + " --base " + path("base.yaml")));
  expectTheScene(detect("--cloud " + path("c.pcd") + " --calibration-cloud " + path("c.pcd")));
  EXPECT_EQ(detect("--cloud " + path("c.pcd") + " --base floor").at("boxes").size(), 2u);

  adapters::CloudBagOptions options;
  adapters::writeCloudBag({path("c.pcd")}, path("c.bag"), options);
  expectTheScene(detect("--bag " + path("c.bag") + " --topic " + options.topic));
  expectTheScene(detect("--bag " + path("c.bag")));
}

TEST_F(DetectBoxes, takesTheNodesParameterFile) {
  std::ofstream(path("p.yaml")) << "detection: {box: {min_side_m: 0.6}}\n";
  const nlohmann::json json = detect("--cloud " + path("c.pcd") + " --params " + path("p.yaml"));
  EXPECT_TRUE(json.at("boxes").empty());
  ASSERT_EQ(json.at("rejected").size(), 2u);
  EXPECT_EQ(json.at("rejected").at(0).at("reason"), "too small");
  const std::string shipped = std::string(MIXED_PALLETIZING_SOURCE_DIR) + "/config/box_detector.yaml";
  expectTheScene(detect("--cloud " + path("c.pcd") + " --params " + shipped));
}

TEST_F(DetectBoxes, saysInOneLineWhatIsWrong) {
  const std::string json = " --json " + path("d.json");
  expectOneClearLine(json, "either a cloud file or a bag");
  expectOneClearLine("--cloud " + path("c.pcd") + " --bag x.bag" + json, "either a cloud file or a bag");
  expectOneClearLine("--cloud /nowhere.pcd" + json, "/nowhere.pcd");
  expectOneClearLine("--bag /nowhere.bag" + json, "/nowhere.bag");
  expectOneClearLine("--cloud " + path("c.pcd"), "json");
  expectOneClearLine("--cloud " + path("c.pcd") + " --topic /x" + json, "topic");
  expectOneClearLine("--cloud " + path("c.pcd") + " --repeat 0" + json, "repeat");
  expectOneClearLine("--cloud " + path("c.pcd") + " --base /nowhere.yaml" + json, "/nowhere.yaml");
  expectOneClearLine("--cloud " + path("c.pcd") + " --json /nowhere/d.json", "/nowhere/d.json");
  std::ofstream(path("p.yaml")) << "detection: {box: {min_sid_m: 0.6}, top: {slice_m: -1}}\n";
  expectOneClearLine("--cloud " + path("c.pcd") + " --params " + path("p.yaml") + json,
                     "detection.box.min_sid_m");
  std::ofstream(path("m.yaml")) << "detection: {marker: {id: 5}}\n";
  expectOneClearLine("--cloud " + path("c.pcd") + " --params " + path("m.yaml") + json, "seen: 0");
  adapters::writeCloudBag({path("c.pcd")}, path("c.bag"), adapters::CloudBagOptions());
  expectOneClearLine("--bag " + path("c.bag") + " --topic /other" + json, "/other");
}

TEST_F(DetectBoxes, findsTheRecordedCarton) {
  const auto cloud = test::recordedData("real/fau1.pcd");
  if (!cloud) GTEST_SKIP();
  const nlohmann::json json = detect("--cloud " + *cloud + " --base floor");
  ASSERT_EQ(json.at("boxes").size(), 1u);
  EXPECT_NEAR(json.at("boxes")[0].at("size")[0].get<double>(), 0.448, 0.015);
  EXPECT_NEAR(json.at("boxes")[0].at("size")[1].get<double>(), 0.355, 0.015);
  EXPECT_NEAR(json.at("boxes")[0].at("size")[2].get<double>(), 0.187, 0.015);
}

}  // namespace
}  // namespace mixed_palletizing
