// Detected boxes as vision_msgs (those of ROS 1: branch noetic-devel).
#pragma once

#include <cstdint>

#include <vision_msgs/Detection3DArray.h>

#include <mixed_palletizing/BoxArray.h>

namespace mixed_palletizing::converters {

/// One detection for every box, in the same order and frame: pose and size of the box; one hypothesis of class
/// `class_id` with the box's covariance, whose score is the visible share of the top, 0 to 1. No source cloud.
vision_msgs::Detection3DArrayPtr toVisionDetections(const BoxArray& boxes, std::int64_t class_id);

}  // namespace mixed_palletizing::converters
