// Detected boxes as jsk_recognition_msgs.
#pragma once

#include <jsk_recognition_msgs/BoundingBoxArray.h>

#include <mixed_palletizing/BoxArray.h>

namespace mixed_palletizing::converters {

/// One bounding box for every box, in the same order and frame: `label` is the box's id, `value` the visible share of
/// its top, 0 to 1.
jsk_recognition_msgs::BoundingBoxArrayPtr toJskBoxes(const BoxArray& boxes);

}  // namespace mixed_palletizing::converters
