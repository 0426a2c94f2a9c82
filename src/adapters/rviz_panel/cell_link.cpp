#include "cell_link.hpp"

#include <utility>

#include <ros/service.h>

#include <mixed_palletizing/adapters/names.hpp>

namespace mixed_palletizing::rviz_panel {
namespace {

constexpr int kStatesKept = 10;

}  // namespace

CellLink::CellLink(const std::string& cell, Handlers handlers)
    : node_(cell), handlers_(std::move(handlers)), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  state_ = node_.subscribe<PalletState>(
      std::string("pick_planner/") + adapters::names::kPalletState, kStatesKept,
      [this](const PalletState::ConstPtr& message) { handlers_.state(*message); });
  decision_ = node_.subscribe<PickDecision>(
      std::string("pick_planner/") + adapters::names::kLastDecision, 1,
      [this](const PickDecision::ConstPtr& message) { handlers_.decision(*message); });
  report_ = node_.subscribe<std_msgs::String>(
      "pallet_report", 1,
      [this](const std_msgs::String::ConstPtr& message) { handlers_.report(message->data); });
  spinner_.start();
}

CellLink::~CellLink() {
  close();
  spinner_.stop();
}

bool CellLink::has(const std::string& name) const {
  return ros::service::exists(node_.resolveName(name), false);
}

void CellLink::requireServer(const std::string& name) {
  if (!has(name)) throw CallError(node_.resolveName(name) + " is not there: is the cell running?");
}

void CellLink::enter(const ros::ServiceClient& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (closed_) throw CallError("the panel is closing");
  running_ = client;
}

void CellLink::leave() {
  const std::lock_guard<std::mutex> lock(mutex_);
  running_ = ros::ServiceClient();
}

void CellLink::close() {
  state_.shutdown();
  decision_.shutdown();
  report_.shutdown();
  const std::lock_guard<std::mutex> lock(mutex_);
  closed_ = true;
  running_.shutdown();
}

}  // namespace mixed_palletizing::rviz_panel
