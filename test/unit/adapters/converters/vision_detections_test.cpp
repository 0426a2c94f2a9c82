#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/converters/vision_detections.hpp>

namespace mixed_palletizing::converters {
namespace {

TEST(VisionDetections, keepOrderFramePoseSizeAndCovariance) {
  BoxArray boxes;
  boxes.header.frame_id = "base";
  boxes.header.stamp = ros::Time(12, 34);
  boxes.boxes.resize(2);
  Box& box = boxes.boxes[1];
  box.id = 1;
  box.pose.pose.position.x = 0.5;
  box.pose.pose.orientation.w = 1.0;
  box.pose.covariance[35] = 1e-4;
  box.size.x = 0.4;
  box.size.y = 0.3;
  box.size.z = 0.2;
  box.top_visibility = 0.75;

  const auto array = toVisionDetections(boxes, 7);
  EXPECT_EQ(array->header.frame_id, "base");
  ASSERT_EQ(array->detections.size(), 2u);
  const auto& detection = array->detections[1];
  EXPECT_EQ(detection.header.stamp, boxes.header.stamp);
  EXPECT_EQ(detection.bbox.center, box.pose.pose);
  EXPECT_EQ(detection.bbox.size, box.size);
  ASSERT_EQ(detection.results.size(), 1u);
  EXPECT_EQ(detection.results[0].id, 7);
  EXPECT_EQ(detection.results[0].score, 0.75);
  EXPECT_EQ(detection.results[0].pose, box.pose);
}

TEST(VisionDetections, noneForNone) { EXPECT_TRUE(toVisionDetections(BoxArray(), 0)->detections.empty()); }

}  // namespace
}  // namespace mixed_palletizing::converters
