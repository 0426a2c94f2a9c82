#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/converters/jsk_boxes.hpp>

namespace mixed_palletizing::converters {
namespace {

TEST(JskBoxes, keepOrderFramePoseAndSize) {
  BoxArray boxes;
  boxes.header.frame_id = "base";
  boxes.header.stamp = ros::Time(12, 34);
  boxes.boxes.resize(2);
  Box& box = boxes.boxes[1];
  box.id = 1;
  box.pose.pose.position.y = -0.5;
  box.pose.pose.orientation.w = 1.0;
  box.size.x = 0.4;
  box.size.y = 0.3;
  box.size.z = 0.2;
  box.top_visibility = 0.75;

  const auto array = toJskBoxes(boxes);
  EXPECT_EQ(array->header.frame_id, "base");
  ASSERT_EQ(array->boxes.size(), 2u);
  EXPECT_EQ(array->boxes[1].header.stamp, boxes.header.stamp);
  EXPECT_EQ(array->boxes[1].pose, box.pose.pose);
  EXPECT_EQ(array->boxes[1].dimensions, box.size);
  EXPECT_EQ(array->boxes[1].value, 0.75f);
  EXPECT_EQ(array->boxes[1].label, 1u);
}

TEST(JskBoxes, noneForNone) { EXPECT_TRUE(toJskBoxes(BoxArray())->boxes.empty()); }

}  // namespace
}  // namespace mixed_palletizing::converters
