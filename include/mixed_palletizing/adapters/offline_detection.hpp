// Detection in one cloud from a file or a bag, as the nodelet does it with a message.
#pragma once

#include <functional>
#include <string>

#include <sensor_msgs/PointCloud2.h>

#include <mixed_palletizing/detection/base_frame.hpp>
#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::adapters {

struct OfflineDetectionRequest {
  std::string cloud;              ///< PCD or PLY file; or else
  std::string bag;                ///< a bag, of which the first cloud is taken
  std::string topic;              ///< of the bag; empty: its only topic of clouds
  std::string calibration_cloud;  ///< file in which the base frame is looked for; empty: in the cloud itself
  std::string base = "marker";    ///< "marker", "floor", or a calibration file
  std::string params;             ///< parameter file of the detector node; empty: the defaults
  std::string mode;               ///< "palletize" or "depalletize"; empty: as the parameter file says
  std::string method;             ///< "best" or "thesis"; empty: as the parameter file says
  int repeat = 1;                 ///< detections of the same cloud; times are medians
};

struct OfflineDetection {
  geometry::Pose base_from_camera = geometry::Pose::Identity();
  detection::Detections detections;
  double total_ms = 0.0;  ///< from the message to the boxes
  std::string base;       ///< one line for people: where the base frame comes from
};

/// Every cloud passes through a message and its checks, as in the node. Throws std::runtime_error or
/// std::invalid_argument with one clear message for anything that is wrong.
OfflineDetection detectOffline(const OfflineDetectionRequest& request);

/// One cloud of a bag: what was found in it, or why it is no usable cloud.
struct ReplayedCloud {
  sensor_msgs::PointCloud2ConstPtr message;
  std::string fault;  ///< name of the CloudFault; empty when the cloud was searched
  OfflineDetection result;
};

/// Detects in every cloud of request.bag in recorded order, without clocks, as one running detector. The base
/// frame is looked for in the calibration cloud, else in the first usable cloud of the bag. Throws as
/// detectOffline(), and std::runtime_error when the bag holds no usable cloud.
void replayOffline(const OfflineDetectionRequest& request,
                   const std::function<void(const ReplayedCloud&)>& use);

}  // namespace mixed_palletizing::adapters
