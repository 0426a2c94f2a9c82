// Detected boxes as jsk_recognition_msgs/BoundingBoxArray.
#include <ros/ros.h>

#include <mixed_palletizing/adapters/converters/jsk_boxes.hpp>
#include <mixed_palletizing/adapters/converters/topic_converter.hpp>
#include <mixed_palletizing/adapters/master_watch.hpp>
#include <mixed_palletizing/adapters/names.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace converters = mixed_palletizing::converters;

int main(int argc, char** argv) {
  ros::init(argc, argv, "boxes_to_jsk");
  const converters::TopicConverter<mixed_palletizing::BoxArray, jsk_recognition_msgs::BoundingBoxArray>
      converter(ros::NodeHandle(), adapters::names::kBoxes, adapters::names::kBoundingBoxes,
                converters::toJskBoxes);
  const adapters::MasterWatch watch(adapters::endNode);
  ros::spin();
  return watch.forgotten() ? 1 : 0;
}
