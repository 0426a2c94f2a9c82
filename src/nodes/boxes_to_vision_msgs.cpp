// Detected boxes as vision_msgs/Detection3DArray.
#include <ros/ros.h>

#include <mixed_palletizing/adapters/converters/topic_converter.hpp>
#include <mixed_palletizing/adapters/converters/vision_detections.hpp>
#include <mixed_palletizing/adapters/master_watch.hpp>
#include <mixed_palletizing/adapters/names.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace converters = mixed_palletizing::converters;

int main(int argc, char** argv) {
  ros::init(argc, argv, "boxes_to_vision_msgs");
  const int class_id = ros::param::param("~class_id", 0);
  const converters::TopicConverter<mixed_palletizing::BoxArray, vision_msgs::Detection3DArray> converter(
      ros::NodeHandle(), adapters::names::kBoxes, adapters::names::kDetections,
      [class_id](const auto& boxes) { return converters::toVisionDetections(boxes, class_id); });
  const adapters::MasterWatch watch(adapters::endNode);
  ros::spin();
  return watch.forgotten() ? 1 : 0;
}
