#include <algorithm>
#include <cmath>

#include <boost/make_shared.hpp>
#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <mixed_palletizing/adapters/box_messages.hpp>
#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/units.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::adapters {
namespace {

template <typename A, typename B>
constexpr bool sameBit(A message, B detection) {
  return static_cast<int>(message) == static_cast<int>(detection);
}
static_assert(sameBit(Box::OCCLUDED, detection::kOccluded) &&
                  sameBit(Box::TRUNCATED, detection::kTruncated) &&
                  sameBit(Box::TOUCHING, detection::kTouching) &&
                  sameBit(Box::UNEVEN_TOP, detection::kUnevenTop) &&
                  sameBit(Box::INCOMPLETE, detection::kIncomplete) &&
                  sameBit(Box::HEIGHT_UNKNOWN, detection::kHeightUnknown),
              "the bits of Box.msg are those of the detection");

constexpr double kLargestBoxM = 100.0;

Box toMessage(const detection::DetectedBox& box, std::size_t index) {
  Box message;
  message.id = static_cast<std::uint32_t>(index);
  message.pose.pose = poseMessage(geometry::poseFromYaw(box.center, box.yaw_rad));
  for (Eigen::Index i = 0; i < 36; ++i) {
    message.pose.covariance[static_cast<std::size_t>(i)] = box.pose_covariance(i / 6, i % 6);
  }
  message.size = vectorMessage(box.size);
  message.size_stddev = vectorMessage(box.size_stddev);
  message.top_center = pointMessage(box.top_center);
  message.top_normal = vectorMessage(box.top_normal);
  message.top_visibility = box.top_visibility;
  message.point_count = box.point_count;
  message.flags = box.flags;
  return message;
}

RejectedCluster toMessage(const detection::RejectedCluster& cluster) {
  RejectedCluster message;
  message.reason = static_cast<std::uint8_t>(cluster.reason);
  message.text = cluster.text;
  message.centroid = pointMessage(cluster.centroid);
  message.extent = vectorMessage(cluster.extent);
  return message;
}

}  // namespace

BoxArrayPtr toMessage(const detection::Detections& detections, const std_msgs::Header& header,
                      double processing_ms) {
  auto message = boost::make_shared<BoxArray>();
  message->header = header;
  message->boxes.reserve(detections.boxes.size());
  for (std::size_t i = 0; i < detections.boxes.size(); ++i) {
    message->boxes.push_back(toMessage(detections.boxes[i], i));
  }
  message->rejected.reserve(detections.rejected.size());
  for (const auto& cluster : detections.rejected) message->rejected.push_back(toMessage(cluster));
  message->processing_ms = processing_ms;
  return message;
}

sensor_msgs::ImagePtr labelImage(const detection::Detections& detections, const std_msgs::Header& header) {
  // A view of the labels; toImageMsg() makes the only copy.
  const cv::Mat labels(detections.height, detections.width, CV_16UC1,
                       const_cast<std::uint16_t*>(detections.labels.data()));
  return cv_bridge::CvImage(header, sensor_msgs::image_encodings::TYPE_16UC1, labels).toImageMsg();
}

std::vector<std::string> problems(const Box& box) {
  std::vector<std::string> all;
  const auto check = [&](const char* name, double value, double lowest, bool open) {
    const bool good =
        std::isfinite(value) && value <= kLargestBoxM && (open ? value > lowest : value >= lowest);
    if (!good) all.push_back(std::string(name) + ": " + std::to_string(value) + " m");
  };
  check("size.x", box.size.x, 0.0, true);
  check("size.y", box.size.y, 0.0, true);
  check("size.z", box.size.z, 0.0, true);
  check("size_stddev.x", box.size_stddev.x, 0.0, false);
  check("size_stddev.y", box.size_stddev.y, 0.0, false);
  check("size_stddev.z", box.size_stddev.z, 0.0, false);
  return all;
}

planning::MeasuredBox measuredBox(const Box& box) {
  // Measured sizes stay real numbers: whole millimetres come from the order line they are matched with.
  planning::MeasuredBox measured;
  const double length = std::max(box.size.x, box.size.y);
  const double width = std::min(box.size.x, box.size.y);
  const bool swapped = box.size.y > box.size.x;
  const double length_stddev = swapped ? box.size_stddev.y : box.size_stddev.x;
  const double width_stddev = swapped ? box.size_stddev.x : box.size_stddev.y;
  measured.size_mm = {length * kMillimetersPerMeter, width * kMillimetersPerMeter,
                      box.size.z * kMillimetersPerMeter};
  measured.stddev_mm = {length_stddev * kMillimetersPerMeter, width_stddev * kMillimetersPerMeter,
                        box.size_stddev.z * kMillimetersPerMeter};
  return measured;
}

}  // namespace mixed_palletizing::adapters
