// The tool bag_regression on a bag of simulated clouds.
#include <filesystem>

#include <mixed_palletizing/adapters/cloud_bag.hpp>
#include <mixed_palletizing/adapters/cloud_files.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

#include "tool_fixture.hpp"

namespace mixed_palletizing {
namespace {

class BagRegression : public test::ToolFixture {
 protected:
  BagRegression() : ToolFixture(BAG_REGRESSION_TOOL) {
    simulation::Recipe recipe;
    recipe.groups.front().count = {2, 2};
    recipe.scene.camera.width_px = 480;
    recipe.scene.camera.height_px = 300;
    recipe.scene.noise.depth_stddev_at_1m_m = 0.0003;
    simulation::Scene scene = simulation::recipeScene(recipe, 5, 0);
    adapters::writeCloud(path("a.pcd"), simulation::capture(scene, 5).cloud);
    adapters::writeCloud(path("b.pcd"), simulation::capture(scene, 6).cloud);
    scene.boxes.pop_back();
    adapters::writeCloud(path("less.pcd"), simulation::capture(scene, 6).cloud);
    adapters::writeCloudBag({path("a.pcd"), path("b.pcd")}, path("two.bag"), adapters::CloudBagOptions());
    adapters::writeCloudBag({path("a.pcd"), path("less.pcd")}, path("less.bag"), adapters::CloudBagOptions());
  }

  std::string arguments(const std::string& bag, const std::string& golden = "g.json") const {
    return "--bag " + path(bag) + " --golden " + path(golden);
  }
};

TEST_F(BagRegression, theSameBagGivesTheSameBytesAndNoDifference) {
  ASSERT_EQ(run(arguments("two.bag") + " --update"), 0) << read("err.txt");
  ASSERT_EQ(run(arguments("two.bag", "again.json") + " --update"), 0) << read("err.txt");
  EXPECT_FALSE(read("g.json").empty());
  EXPECT_EQ(read("g.json"), read("again.json"));
  EXPECT_EQ(run(arguments("two.bag")), 0) << read("out.txt");
  EXPECT_NE(read("out.txt").find("2 clouds, 0 differences"), std::string::npos);
}

TEST_F(BagRegression, aMissingBoxIsSaidAndDrawn) {
  ASSERT_EQ(run(arguments("two.bag") + " --update"), 0) << read("err.txt");
  EXPECT_EQ(run(arguments("less.bag") + " --pictures " + path("pictures")), 1);
  EXPECT_NE(read("out.txt").find("cloud 1 at 2.000 s: missing: box"), std::string::npos) << read("out.txt");
  EXPECT_TRUE(std::filesystem::exists(path("pictures/cloud_0001.png")));
  EXPECT_FALSE(std::filesystem::exists(path("pictures/cloud_0000.png")));
}

TEST_F(BagRegression, saysInOneLineWhatIsWrong) {
  expectOneClearLine(arguments("two.bag"), "--update");
  expectOneClearLine("--bag /nowhere.bag --update --golden " + path("g.json"), "/nowhere.bag");
  expectOneClearLine("--bag " + path("two.bag"), "golden");
  expectOneClearLine(arguments("two.bag") + " --update --base /nowhere.yaml", "/nowhere.yaml");
  ASSERT_EQ(run(arguments("two.bag") + " --update"), 0) << read("err.txt");
  expectOneClearLine(arguments("two.bag") + " --size_tolerance_m -1", "size_m");
  expectOneClearLine(arguments("less.bag") + " --pictures /dev/null/x", "/dev/null/x");
}

}  // namespace
}  // namespace mixed_palletizing
