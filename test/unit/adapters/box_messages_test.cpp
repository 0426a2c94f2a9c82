#include <cmath>
#include <limits>

#include <cv_bridge/cv_bridge.h>
#include <gtest/gtest.h>
#include <sensor_msgs/image_encodings.h>

#include <mixed_palletizing/RejectedCluster.h>
#include <mixed_palletizing/adapters/box_messages.hpp>

namespace mixed_palletizing::adapters {
namespace {

detection::Detections twoBoxes() {
  detection::Detections detections;
  detections.boxes.resize(2);
  detection::DetectedBox& box = detections.boxes[1];
  box.center = {1.0, 2.0, 0.1};
  box.top_center = {1.0, 2.0, 0.2};
  box.top_normal = {0.0, -0.6, 0.8};
  box.yaw_rad = -0.5;
  box.size = {0.4, 0.3, 0.2};
  box.size_stddev = {0.001, 0.002, 0.003};
  for (Eigen::Index i = 0; i < 36; ++i) box.pose_covariance(i / 6, i % 6) = static_cast<double>(i);
  box.top_visibility = 0.75;
  box.point_count = 1234;
  box.flags = detection::kOccluded | detection::kTouching;
  detections.rejected.push_back({detection::RejectReason::kTooLarge, "2 m", {1, 2, 3}, {4, 5, 6}});
  detections.width = 3;
  detections.height = 2;
  detections.labels = {0, 1, 2, 2, 1, 0};
  return detections;
}

std_msgs::Header header() {
  std_msgs::Header header;
  header.frame_id = "aruco_base";
  header.stamp = ros::Time(12, 34);
  return header;
}

TEST(BoxMessages, carryEveryField) {
  const BoxArrayPtr message = toMessage(twoBoxes(), header(), 12.5);
  EXPECT_EQ(message->header.frame_id, "aruco_base");
  EXPECT_EQ(message->header.stamp, ros::Time(12, 34));
  EXPECT_EQ(message->processing_ms, 12.5);
  ASSERT_EQ(message->boxes.size(), 2u);
  const Box& box = message->boxes[1];
  EXPECT_EQ(box.id, 1u);
  EXPECT_EQ(box.pose.pose.position.y, 2.0);
  EXPECT_NEAR(box.pose.pose.orientation.z, std::sin(-0.25), 1e-12);
  EXPECT_NEAR(box.pose.pose.orientation.w, std::cos(-0.25), 1e-12);
  EXPECT_EQ(box.pose.covariance[7], 7.0);
  EXPECT_EQ(box.pose.covariance[35], 35.0);
  EXPECT_EQ(box.size.x, 0.4);
  EXPECT_EQ(box.size_stddev.z, 0.003);
  EXPECT_EQ(box.top_center.z, 0.2);
  EXPECT_EQ(box.top_normal.y, -0.6);
  EXPECT_EQ(box.top_normal.z, 0.8);
  EXPECT_EQ(box.top_visibility, 0.75);
  EXPECT_EQ(box.point_count, 1234u);
  EXPECT_EQ(box.flags, Box::OCCLUDED | Box::TOUCHING);
  ASSERT_EQ(message->rejected.size(), 1u);
  EXPECT_EQ(message->rejected[0].reason, RejectedCluster::TOO_LARGE);
  EXPECT_EQ(message->rejected[0].text, "2 m");
  EXPECT_EQ(message->rejected[0].extent.z, 6.0);
}

TEST(BoxMessages, labelsAreAnImageOfTheGrid) {
  const sensor_msgs::ImagePtr image = labelImage(twoBoxes(), header());
  EXPECT_EQ(image->encoding, sensor_msgs::image_encodings::TYPE_16UC1);
  EXPECT_EQ(image->width, 3u);
  EXPECT_EQ(image->height, 2u);
  const auto view = cv_bridge::toCvShare(image);
  EXPECT_EQ(view->image.at<std::uint16_t>(0, 2), 2);
  EXPECT_EQ(view->image.at<std::uint16_t>(1, 0), 2);
  EXPECT_EQ(view->image.at<std::uint16_t>(1, 2), 0);
}

TEST(BoxMessages, measuredSizesAreOrderedAndInMillimeters) {
  Box box;
  box.size.x = 0.2;
  box.size.y = 0.3;
  box.size.z = 0.1;
  box.size_stddev.x = 0.002;
  box.size_stddev.y = 0.003;
  const planning::MeasuredBox measured = measuredBox(box);
  EXPECT_NEAR(measured.size_mm[0], 300.0, 1e-9);
  EXPECT_NEAR(measured.size_mm[1], 200.0, 1e-9);
  EXPECT_NEAR(measured.stddev_mm[0], 3.0, 1e-9);
  EXPECT_NEAR(measured.stddev_mm[1], 2.0, 1e-9);
}

TEST(BoxMessages, refusesSizesThatAreNone) {
  Box box;
  box.size.x = box.size.y = box.size.z = 0.1;
  EXPECT_TRUE(problems(box).empty());
  for (const double bad : {0.0, -0.1, std::nan(""), std::numeric_limits<double>::infinity(), 101.0}) {
    Box wrong = box;
    wrong.size.y = bad;
    EXPECT_EQ(problems(wrong).size(), 1u) << bad;
  }
  box.size_stddev.z = std::nan("");
  EXPECT_EQ(problems(box).size(), 1u);
  box.size_stddev.z = -0.001;
  EXPECT_EQ(problems(box).size(), 1u);
}

}  // namespace
}  // namespace mixed_palletizing::adapters
