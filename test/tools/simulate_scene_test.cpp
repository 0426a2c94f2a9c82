// The tool simulate_scene, run as a user runs it.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <mixed_palletizing/adapters/cloud_files.hpp>

#include "tool_fixture.hpp"

namespace {

class SimulateScene : public mixed_palletizing::test::ToolFixture {
 protected:
  SimulateScene() : ToolFixture(SIMULATE_SCENE_TOOL) {}

  const std::string scene_ = MIXED_PALLETIZING_SOURCE_DIR "/config/scenes/three_boxes.yaml";
};

TEST_F(SimulateScene, WritesCloudTruthAndMask) {
  const std::string common = "--scene " + scene_ + " --truth " + path("t.json");
  ASSERT_EQ(run(common + " --out " + path("c.pcd") + " --mask " + path("m.png") + " --seed 7"), 0)
      << read("err.txt");
  const auto cloud = mixed_palletizing::adapters::readCloud(path("c.pcd"));
  EXPECT_EQ(cloud.width, 1920);
  EXPECT_EQ(cloud.height, 1200);
  EXPECT_TRUE(cloud.has_color);
  const nlohmann::json truth = nlohmann::json::parse(read("t.json"));
  EXPECT_EQ(truth.at("seed"), 7);
  EXPECT_EQ(truth.at("boxes").size(), 3u);
  EXPECT_GT(std::filesystem::file_size(path("m.png")), 1000u);

  ASSERT_EQ(run(common + " --out " + path("same.pcd") + " --seed 7 --threads 1"), 0);
  ASSERT_EQ(run(common + " --out " + path("other.pcd") + " --seed 8"), 0);
  EXPECT_TRUE(read("c.pcd") == read("same.pcd"));
  EXPECT_FALSE(read("c.pcd") == read("other.pcd"));
}

TEST_F(SimulateScene, MeshesGoIntoTruthAndMask) {
  const std::string scene = MIXED_PALLETIZING_SOURCE_DIR "/config/scenes/stacked_boxes.yaml";
  ASSERT_EQ(run("--scene " + scene + " --truth " + path("t.json") + " --out " + path("c.pcd")), 0)
      << read("err.txt");
  EXPECT_EQ(read("err.txt"), "");
  const nlohmann::json truth = nlohmann::json::parse(read("t.json"));
  EXPECT_EQ(truth.at("boxes").size(), 5u);
  ASSERT_EQ(truth.at("objects").size(), 1u);
  EXPECT_EQ(truth.at("objects").at(0).at("name"), "pallet");
  EXPECT_GT(truth.at("objects").at(0).at("visible_pixels"), 1000);
}

TEST_F(SimulateScene, WarnsOfThingsWithinEachOther) {
  std::ofstream(path("s.yaml"))
      << "camera: {width_px: 64, height_px: 40, eye_m: [0, 0, 2], target_m: [0, 0, 0]}\n"
         "boxes: [{name: a}]\nobjects: [{cylinder: {}}]\n";
  EXPECT_EQ(run("--scene " + path("s.yaml") + " --truth " + path("t.json") + " --out " + path("c.pcd")), 0);
  EXPECT_EQ(read("err.txt"), path("s.yaml") + ": warning: objects[0]: reaches into boxes[0]\n");
}

TEST_F(SimulateScene, WritesImagesCalibrationAndBag) {
  ASSERT_EQ(run("--scene " + scene_ + " --truth " + path("t.json") + " --out " + path("c.ply") + " --color " +
                path("c.png") + " --depth " + path("d.tiff") + " --camera_info " + path("i.yaml") +
                " --bag " + path("b.bag") + " --layout xyzcrgb"),
            0)
      << read("err.txt");
  for (const std::string name : {"c.ply", "c.png", "d.tiff", "i.yaml", "b.bag"}) {
    EXPECT_GT(std::filesystem::file_size(path(name)), 200u) << name;
  }
  EXPECT_NE(read("c.ply").substr(0, 400).find("property float c\n"), std::string::npos);
}

TEST_F(SimulateScene, BadInputIsOneClearLine) {
  const std::string outputs = " --out " + path("c.pcd") + " --truth " + path("t.json");
  const std::string bad = path("bad.yaml");
  std::ofstream(bad)
      << "camera: {eye_m: [0, 0, 1], target_m: [0, 0, 0]}\nboxes:\n  - {sise_m: 3}\nfloor: 3\n";
  expectOneClearLine("--scene " + bad + outputs, "bad.yaml:3: boxes[0].sise_m");
  expectOneClearLine("--scene " + path("none.yaml") + outputs, "none.yaml");
  expectOneClearLine("--scene " + scene_, "--out");
  expectOneClearLine("--scene " + scene_ + outputs + " --threads 0", "threads");
  expectOneClearLine("--scene " + scene_ + " --truth " + path("t.json") + " --out " + path("no/c.pcd"),
                     "no/c.pcd");
  expectOneClearLine("--scene " + scene_ + " --truth " + path("t.json") + " --out " + path("c.txt"), "c.txt");
  expectOneClearLine("--scene " + scene_ + outputs + " --mask " + path("m.jpg"), "m.jpg");
  expectOneClearLine("--scene " + scene_ + outputs + " --layout abc", "'abc' is none of xyz,");
}

TEST_F(SimulateScene, Helps) {
  EXPECT_EQ(run("--help"), 0);
  EXPECT_NE(read("out.txt").find("--scene"), std::string::npos);
}

}  // namespace
