#include <boost/make_shared.hpp>

#include <mixed_palletizing/adapters/converters/vision_detections.hpp>

namespace mixed_palletizing::converters {

vision_msgs::Detection3DArrayPtr toVisionDetections(const BoxArray& boxes, std::int64_t class_id) {
  auto array = boost::make_shared<vision_msgs::Detection3DArray>();
  array->header = boxes.header;
  for (const Box& box : boxes.boxes) {
    vision_msgs::Detection3D detection;
    detection.header = boxes.header;
    detection.bbox.center = box.pose.pose;
    detection.bbox.size = box.size;
    vision_msgs::ObjectHypothesisWithPose hypothesis;
    hypothesis.id = class_id;
    hypothesis.score = box.top_visibility;
    hypothesis.pose = box.pose;
    detection.results.push_back(hypothesis);
    array->detections.push_back(detection);
  }
  return array;
}

}  // namespace mixed_palletizing::converters
