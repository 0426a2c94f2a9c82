#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/golden_detections.hpp>

namespace mixed_palletizing::adapters {
namespace {

GoldenBox box(double x, double y) {
  GoldenBox b;
  b.center = {x, y, 0.1};
  b.yaw_rad = 0.3;
  b.size = {0.3, 0.2, 0.2};
  b.flags = {"TOUCHING"};
  return b;
}

GoldenDetections twoClouds() {
  GoldenDetections golden;
  golden.base_from_camera.translation() = Eigen::Vector3d(0.1, -0.2, 1.5);
  golden.clouds.push_back({1000000007u, "", {box(0.0, 0.0), box(0.5, 0.1)}});
  golden.clouds.push_back({2000000009u, "wrong_row_step", {}});
  return golden;
}

std::vector<GoldenDifference> differences(const GoldenDetections& now) {
  return compareGolden(twoClouds(), now, GoldenTolerances());
}

std::string temporary(const std::string& name) { return testing::TempDir() + "golden_" + name; }

TEST(GoldenDetections, aFileComesBackAsItWas) {
  const std::string path = temporary("a.json");
  writeGolden(path, twoClouds());
  const GoldenDetections read = readGolden(path);
  EXPECT_EQ(goldenJson(read), goldenJson(twoClouds()));
  EXPECT_TRUE(differences(read).empty());
}

TEST(GoldenDetections, smallChangesAndAHalfTurnAreNoDifference) {
  GoldenDetections now = twoClouds();
  GoldenBox& moved = now.clouds[0].boxes[0];
  moved.center.x() += 0.0015;
  moved.size.z() -= 0.002;
  moved.yaw_rad += 0.005 - M_PI;
  std::swap(now.clouds[0].boxes[0], now.clouds[0].boxes[1]);
  EXPECT_TRUE(differences(now).empty());
}

TEST(GoldenDetections, everyChangeIsNamed) {
  const auto only = [](const std::vector<GoldenDifference>& found, int cloud, const std::string& words) {
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].cloud, cloud);
    EXPECT_NE(found[0].text.find(words), std::string::npos) << found[0].text;
  };
  GoldenDetections now = twoClouds();
  now.clouds[0].boxes[1].center.y() += 0.004;
  only(differences(now), 0, "moved by 4.00 mm");
  now = twoClouds();
  now.clouds[0].boxes[1].size.x() += 0.005;
  only(differences(now), 0, "length 305.00 mm was 300.00 mm");
  now = twoClouds();
  now.clouds[0].boxes[0].yaw_rad += 0.1;
  only(differences(now), 0, "turned by 5.730 deg");
  now = twoClouds();
  now.clouds[0].boxes[0].flags.clear();
  only(differences(now), 0, "flags none were TOUCHING");
  now = twoClouds();
  now.clouds[0].boxes.pop_back();
  only(differences(now), 0, "missing: box 300.0 x 200.0 x 200.0 mm");
  now = twoClouds();
  now.clouds[0].boxes.push_back(box(-0.5, 0.0));
  only(differences(now), 0, "new: box");
  now = twoClouds();
  now.clouds[1].fault.clear();
  only(differences(now), 1, "wrong_row_step");
  now = twoClouds();
  now.clouds[1].stamp_ns += 1;
  only(differences(now), 1, "another cloud");
  now = twoClouds();
  now.clouds.pop_back();
  only(differences(now), -1, "1 clouds were 2");
  now = twoClouds();
  now.base_from_camera.translation().z() += 0.01;
  only(differences(now), -1, "base frame moved by 10.00 mm");
}

TEST(GoldenDetections, aNumberThatIsNoneIsADifference) {
  GoldenDetections now = twoClouds();
  now.clouds[0].boxes[0].size.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(differences(now).size(), 1u);
  now = twoClouds();
  now.base_from_camera.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(differences(now).size(), 1u);
}

TEST(GoldenDetections, brokenFilesAndTolerancesAreRefused) {
  EXPECT_THROW(readGolden("/nowhere/g.json"), std::runtime_error);
  EXPECT_THROW(writeGolden("/nowhere/g.json", twoClouds()), std::runtime_error);
  const std::string whole = goldenJson(twoClouds());
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("{}"), whole.substr(0, whole.size() / 2)}) {
    std::ofstream(temporary("bad.json")) << text;
    EXPECT_THROW(readGolden(temporary("bad.json")), std::runtime_error) << text;
  }
  GoldenTolerances tolerances;
  tolerances.size_m = -1.0;
  tolerances.yaw_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problems(tolerances).size(), 2u);
  EXPECT_THROW(compareGolden(twoClouds(), twoClouds(), tolerances), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::adapters
