// The simulated cell at the ROS border: the camera driver's topics and services before a pick area.
#pragma once

#include <mutex>

#include <ros/node_handle.h>
#include <std_srvs/Empty.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <mixed_palletizing/BoxArray.h>
#include <mixed_palletizing/TakeBox.h>
#include <mixed_palletizing/adapters/cell/simulator_options.hpp>
#include <mixed_palletizing/adapters/cell/simulator_pick_area.hpp>
#include <mixed_palletizing/adapters/cloud_layout.hpp>

namespace mixed_palletizing::cell {

/// Behaves like Zivid's ROS 1 driver (ros1-master, December 2024): `capture` publishes one cloud and its images
/// on the topics somebody listens to, stamped after the capture. The driver's service type zivid_camera/Capture is
/// as empty as std_srvs/Empty, so that clients of the one can call the other. Beside them, `take_box` and the
/// latched topic `truth`. No callback lets an exception out.
class CellSimulator {
 public:
  /// `node`: the camera's namespace, not the global one, as with the driver. Throws std::invalid_argument with all
  /// wrong parameters, std::runtime_error when the file of orders cannot be read.
  CellSimulator(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

 private:
  bool onCapture(std_srvs::EmptyRequest& request, std_srvs::EmptyResponse& response);
  bool onTake(TakeBoxRequest& request, TakeBoxResponse& response);
  void capture();
  void take(const TakeBoxRequest& request, TakeBoxResponse& response);
  bool listened() const;
  void publishTruth();

  const CellSimulatorOptions options_;
  const adapters::CloudLayout cloud_layout_;
  const instances::Instance instance_;
  std::mutex mutex_;  // guards scene_, area_ and captures_: a nodelet's callbacks may run at the same time
  simulation::Scene scene_;
  PickArea area_;
  std::uint64_t captures_ = 0;
  ros::NodeHandle node_;
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_;
  ros::Publisher points_xyz_;
  ros::Publisher points_xyzrgba_;
  ros::Publisher color_image_;
  ros::Publisher color_info_;
  ros::Publisher depth_image_;
  ros::Publisher depth_info_;
  ros::Publisher truth_;
  ros::ServiceServer capture_service_;
  ros::ServiceServer take_service_;
};

}  // namespace mixed_palletizing::cell
