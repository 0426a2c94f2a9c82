// The tool simulate_dataset, run as a user runs it, and what the detector makes of its files.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tool_fixture.hpp"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const char* const kSmall =
    "camera: {width_px: 480, height_px: 300, projector_m: [0.12, 0, 0]}\n"
    "noise: {depth_stddev_at_1m_m: 0.0002, no_data_on_black: true, flying_pixel_ratio: 0.3}\n"
    "groups: [{count: [1, 3], top_visibility: 1}]\n";

class SimulateDataset : public mixed_palletizing::test::ToolFixture {
 protected:
  SimulateDataset() : ToolFixture(SIMULATE_DATASET_TOOL) { write("r.yaml", kSmall); }

  int simulate(const std::string& arguments) const {
    return run("--recipe " + path("r.yaml") + " " + arguments);
  }

  std::map<std::string, std::string> contents(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path(name))) {
      if (entry.is_regular_file())
        files[fs::relative(entry.path(), path(name)).string()] = read(entry.path().string());
    }
    return files;
  }

  /// Boxes that the detector finds.
  json detect(const std::string& arguments) const {
    EXPECT_EQ(runTool(DETECT_BOXES_TOOL, arguments + " --json " + path("d.json")), 0) << read("err.txt");
    const json found = json::parse(read("d.json"), nullptr, false);
    return found.is_object() ? found.at("boxes") : json();
  }
};

TEST_F(SimulateDataset, KilledAnywhereItGoesOnWhereItWas) {
  const std::string common = "--count 8 --seed 3 --threads 2 --out ";
  ASSERT_EQ(simulate(common + path("whole")), 0) << read("err.txt");
  EXPECT_NE(read("out.txt").find("8 scenes, 8 of them written now"), std::string::npos);
  for (const std::string delay : {"0.05", "0.15", "0.3"}) {
    runTool("timeout -s KILL " + delay + " " + SIMULATE_DATASET_TOOL,
            "--recipe " + path("r.yaml") + " " + common + path("killed"));
    ASSERT_EQ(simulate(common + path("killed") + " --quiet"), 0) << read("err.txt");
    EXPECT_EQ(read("out.txt"), "");
    EXPECT_TRUE(contents("whole") == contents("killed")) << "killed after " << delay << " s";
    fs::remove_all(path("killed"));
  }
}

TEST_F(SimulateDataset, TheDetectorReadsEveryLayout) {
  for (const std::string layout : {"default", "xyzrgba_float32", "xyzcrgb"}) {
    SCOPED_TRACE(layout);
    const std::string out = path(layout);
    ASSERT_EQ(simulate("--count 1 --seed 4 --bag --cloud ply --layout " + layout + " --out " + out), 0)
        << read("err.txt");
    const json truth = json::parse(read(out + "/000000/truth.json")).at("boxes");
    const json from_file = detect("--cloud " + out + "/000000/cloud.ply");
    const json from_bag = detect("--bag " + out + "/000000/capture.bag --topic /zivid_camera/points/xyzrgba");
    EXPECT_EQ(from_file, from_bag);
    ASSERT_EQ(from_file.size(), truth.size());
    for (const json& box : truth) {
      const bool found = std::any_of(from_file.begin(), from_file.end(), [&](const json& one) {
        double square = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          square += std::pow(
              one.at("top_center").at(axis).get<double>() - box.at("top_center").at(axis).get<double>(), 2);
        }
        return square < 0.003 * 0.003;
      });
      EXPECT_TRUE(found) << box;
    }
  }
}

TEST_F(SimulateDataset, BadInputIsOneClearLine) {
  const std::string recipe = "--recipe " + path("r.yaml") + " ";
  const std::string out = "--out " + path("o") + " ";
  expectOneClearLine(recipe + out, "--count");
  expectOneClearLine(recipe + out + "--count 0", "count: 0");
  expectOneClearLine(recipe + out + "--count 1 --layout xyzw", "'xyzw' is none of xyz,");
  expectOneClearLine(recipe + out + "--count 1 --cloud pdf", "--cloud must be one of pcd, ply");
  expectOneClearLine(recipe + "--out /proc/none --count 1", "/proc/none: cannot make the folder");
  expectOneClearLine("--recipe " + path("none.yaml") + " " + out + "--count 1", "none.yaml: cannot be read");
  std::ofstream(path("bad.yaml")) << "view:\n  distance: 3\n";
  expectOneClearLine("--recipe " + path("bad.yaml") + " " + out + "--count 1",
                     "bad.yaml:2: view.distance: is no");
  ASSERT_EQ(simulate("--count 1 --seed 1 " + out), 0);
  expectOneClearLine(recipe + out + "--count 2 --seed 2", "a data set of another seed (1, not 2)");
  EXPECT_EQ(run("--help"), 0);
}

}  // namespace
