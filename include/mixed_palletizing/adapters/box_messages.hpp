// Detections <-> messages.
#pragma once

#include <string>
#include <vector>

#include <sensor_msgs/Image.h>

#include <mixed_palletizing/Box.h>
#include <mixed_palletizing/BoxArray.h>
#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/planning/box_matching.hpp>

namespace mixed_palletizing::adapters {

/// Boxes and rejected clusters of one cloud; `header` carries the base frame and the cloud's stamp.
BoxArrayPtr toMessage(const detection::Detections& detections, const std_msgs::Header& header,
                      double processing_ms);

/// 16UC1 image of the cloud's grid: 0 = none, i + 1 = boxes[i]; `header` is the cloud's.
sensor_msgs::ImagePtr labelImage(const detection::Detections& detections, const std_msgs::Header& header);

/// Every fault of a detected box that comes from outside: sizes or uncertainties that are not finite, not
/// positive or absurd. Empty when it can be used.
std::vector<std::string> problems(const Box& box);

/// Size and uncertainty of a sound box for the matching with order lines.
planning::MeasuredBox measuredBox(const Box& box);

}  // namespace mixed_palletizing::adapters
