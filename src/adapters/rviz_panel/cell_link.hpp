// The cell as the panel sees it: calls that may wait, on a thread of their own, and what the cell publishes.
#pragma once

#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_msgs/String.h>

#include <mixed_palletizing/PalletState.h>
#include <mixed_palletizing/PickDecision.h>

namespace mixed_palletizing::rviz_panel {

/// A service that is not there or broke off; the message says which.
class CallError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Detector and planner in one namespace. The handlers are called on a thread of the link.
class CellLink {
 public:
  struct Handlers {
    std::function<void(const PalletState&)> state;
    std::function<void(const PickDecision&)> decision;
    std::function<void(const std::string&)> report;  ///< path of the report of a pallet
  };

  CellLink(const std::string& cell, Handlers handlers);
  ~CellLink();
  CellLink(const CellLink&) = delete;
  CellLink& operator=(const CellLink&) = delete;

  /// The answer, however long it takes. `name` is relative to the cell. Throws CallError, also when close() is
  /// called meanwhile.
  template <typename Service>
  typename Service::Response call(const std::string& name, typename Service::Request request) {
    Service both;
    both.request = std::move(request);
    requireServer(name);
    ros::ServiceClient client = node_.serviceClient<Service>(name, true);  // persistent: can be broken off
    enter(client);
    const bool answered = client.call(both);
    leave();
    if (!answered) throw CallError(node_.resolveName(name) + " did not answer");
    return both.response;
  }

  /// Whether a service of the cell is there.
  bool has(const std::string& name) const;

  /// Breaks a running call off; later ones fail at once, and nothing is heard of the cell any more.
  void close();

 private:
  void requireServer(const std::string& name);
  void enter(const ros::ServiceClient& client);
  void leave();

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  Handlers handlers_;
  ros::Subscriber state_;
  ros::Subscriber decision_;
  ros::Subscriber report_;
  ros::AsyncSpinner spinner_;
  std::mutex mutex_;  // guards running_ and closed_
  ros::ServiceClient running_;
  bool closed_ = false;
};

}  // namespace mixed_palletizing::rviz_panel
