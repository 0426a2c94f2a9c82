// The executive's link to a real or simulated cell: ROS services that are waited for and may time out.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <string>
#include <thread>
#include <vector>

#include <ros/node_handle.h>

#include <mixed_palletizing/adapters/cell/executive_link.hpp>
#include <mixed_palletizing/adapters/cell/executive_options.hpp>

namespace mixed_palletizing::cell {

/// roscpp knows no time limit of a call: every call runs in a thread of its own, and one that does not answer is
/// left behind until the node ends. Use from one thread.
class CellServices : public CellLink {
 public:
  CellServices(const ros::NodeHandle& node, const CellLinkOptions& options);

  /// Ends the node's communication when a call is still hanging.
  ~CellServices() override;

  /// Until all services are there and ROS time runs. Throws CellError naming what is missing.
  void waitForAll();

  /// Ends the pallet. Throws CellError.
  void closePallet();

  void capture() override;
  DetectBoxesResponse detect() override;
  CalibrateResponse calibrate() override;
  StartPalletResponse startPallet(const StartPalletRequest& request) override;
  ChooseNextPickResponse choose(const ChooseNextPickRequest& request) override;
  ReportPickResponse report(const ReportPickRequest& request) override;
  GetPalletStateResponse palletState() override;
  void move() override;
  TakeBoxResponse take(const geometry_msgs::PointStamped& point, bool discard) override;
  void say(const std::string& line) override;
  void warn(const std::string& line) override;

 private:
  template <typename Service>
  typename Service::Response call(const std::string& name, const typename Service::Request& request,
                                  double timeout_s, const std::function<void()>& meanwhile = {});
  void waitFor(const std::string& name, std::chrono::steady_clock::time_point deadline);
  void await(const std::string& name, std::future<bool>& answer, double timeout_s,
             const std::function<void()>& meanwhile);
  std::string resolve(const std::string& name_space, const char* name) const;

  ros::NodeHandle node_;
  const CellLinkOptions options_;
  ros::Time last_trigger_;  // zero: nothing was triggered
  std::vector<std::thread> hanging_;
};

}  // namespace mixed_palletizing::cell
