#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <mixed_palletizing/adapters/detections_json.hpp>

namespace mixed_palletizing::adapters {
namespace {

TEST(DetectionsJson, holdsEveryFieldOfTheFormat) {
  detection::Detections detections;
  detections.width = 4;
  detections.height = 3;
  detections.valid_ratio = 0.5;
  detection::DetectedBox box;
  box.center = Eigen::Vector3d(1.0, 2.0, 0.1);
  box.top_center = Eigen::Vector3d(1.0, 2.0, 0.2);
  box.top_normal = Eigen::Vector3d(0.0, 0.6, 0.8);
  box.yaw_rad = 0.5;
  box.size = Eigen::Vector3d(0.3, 0.2, 0.2);
  box.size_stddev = Eigen::Vector3d(0.001, 0.002, 0.003);
  box.top_visibility = 0.75;
  box.point_count = 1234;
  box.flags = detection::kOccluded | detection::kUnevenTop;
  detections.boxes = {box, box};
  detections.rejected.push_back(
      {detection::RejectReason::kTooLarge, "too \"large\"", {1, 2, 3}, {4, 5, NAN}});
  detections.stage_times = {{"noise", 1.5}, {"clusters", 2.5}};
  geometry::Pose pose = geometry::Pose::Identity();
  pose.translation() = Eigen::Vector3d(7.0, 8.0, 9.0);

  const nlohmann::json json = nlohmann::json::parse(detectionsJson(pose, detections, 5.0));
  EXPECT_EQ(json.at("base_from_camera").at(1).at(3), 8.0);
  EXPECT_EQ(json.at("base_from_camera").at(3), (std::vector<double>{0, 0, 0, 1}));
  ASSERT_EQ(json.at("boxes").size(), 2u);
  const nlohmann::json& second = json.at("boxes").at(1);
  EXPECT_EQ(second.at("id"), 1);
  EXPECT_EQ(second.at("size"), (std::vector<double>{0.3, 0.2, 0.2}));
  EXPECT_EQ(second.at("size_stddev"), (std::vector<double>{0.001, 0.002, 0.003}));
  EXPECT_EQ(second.at("top_center"), (std::vector<double>{1.0, 2.0, 0.2}));
  EXPECT_EQ(second.at("center"), (std::vector<double>{1.0, 2.0, 0.1}));
  EXPECT_EQ(second.at("top_normal"), (std::vector<double>{0.0, 0.6, 0.8}));
  EXPECT_EQ(second.at("yaw"), 0.5);
  EXPECT_EQ(second.at("top_visibility"), 0.75);
  EXPECT_EQ(second.at("point_count"), 1234);
  EXPECT_EQ(second.at("flags"), (std::vector<std::string>{"OCCLUDED", "UNEVEN_TOP"}));
  EXPECT_EQ(json.at("rejected").at(0).at("reason"), "too large");
  EXPECT_EQ(json.at("rejected").at(0).at("text"), "too \"large\"");
  EXPECT_TRUE(json.at("rejected").at(0).at("extent").at(2).is_null());
  EXPECT_EQ(json.at("timings_ms").at("clusters"), 2.5);
  EXPECT_EQ(json.at("timings_ms").at("total"), 5.0);
}

TEST(FlagNames, areThoseOfTheMessage) {
  EXPECT_TRUE(flagNames(0).empty());
  EXPECT_EQ(flagNames(31).size(), 5u);
  EXPECT_EQ(flagNames(detection::kTruncated | detection::kTouching | detection::kIncomplete),
            (std::vector<std::string>{"TRUNCATED", "TOUCHING", "INCOMPLETE"}));
}

}  // namespace
}  // namespace mixed_palletizing::adapters
