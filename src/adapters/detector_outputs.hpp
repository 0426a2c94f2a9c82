// What the detector publishes for one cloud; nothing is computed for a topic nobody listens to.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <mixed_palletizing/BoxArray.h>
#include <mixed_palletizing/adapters/cloud_inbox.hpp>
#include <mixed_palletizing/detection/detections.hpp>

namespace mixed_palletizing::adapters {

class DetectorOutputs {
 public:
  /// Topics boxes, markers, labels in the namespace around `private_node`, debug clouds in that itself.
  explicit DetectorOutputs(ros::NodeHandle& private_node);

  /// Somebody listens to what a detection gives.
  bool wanted() const;
  /// Somebody listens to a debug cloud.
  bool stagesWanted() const;

  void publish(const AcceptedCloud& cloud, const detection::Detections& detections,
               const BoxArrayConstPtr& boxes);

 private:
  void publishStages(const AcceptedCloud& cloud, const detection::Detections& detections);

  ros::Publisher boxes_;
  ros::Publisher markers_;
  ros::Publisher labels_;
  std::map<std::string, ros::Publisher> stages_;
};

}  // namespace mixed_palletizing::adapters
