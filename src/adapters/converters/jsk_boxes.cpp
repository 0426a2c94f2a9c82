#include <boost/make_shared.hpp>

#include <mixed_palletizing/adapters/converters/jsk_boxes.hpp>

namespace mixed_palletizing::converters {

jsk_recognition_msgs::BoundingBoxArrayPtr toJskBoxes(const BoxArray& boxes) {
  auto array = boost::make_shared<jsk_recognition_msgs::BoundingBoxArray>();
  array->header = boxes.header;
  for (const Box& box : boxes.boxes) {
    jsk_recognition_msgs::BoundingBox message;
    message.header = boxes.header;
    message.pose = box.pose.pose;
    message.dimensions = box.size;
    message.value = static_cast<float>(box.top_visibility);
    message.label = box.id;
    array->boxes.push_back(message);
  }
  return array;
}

}  // namespace mixed_palletizing::converters
