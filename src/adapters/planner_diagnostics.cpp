#include "planner_diagnostics.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include <ros/node_handle.h>

namespace mixed_palletizing::adapters {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kPeriodS = 1.0;
constexpr double kPercent = 100.0;

}  // namespace

PlannerDiagnostics::PlannerDiagnostics(const ros::NodeHandle& private_node, std::string journal)
    : journal_(std::move(journal)), updater_(private_node, private_node, private_node.getNamespace()) {
  updater_.setHardwareID("none");
  updater_.add("pallet", this, &PlannerDiagnostics::reportPallet);
  updater_.add("services", this, &PlannerDiagnostics::reportServices);
  timer_ =
      ros::NodeHandle(private_node)
          .createSteadyTimer(ros::WallDuration(kPeriodS), [this](const ros::SteadyTimerEvent&) { update(); });
}

void PlannerDiagnostics::show(const PalletState& state) {
  std::lock_guard<std::mutex> lock(mutex_);
  state_ = state;
}

void PlannerDiagnostics::decided(double decision_ms) {
  std::lock_guard<std::mutex> lock(mutex_);
  ++decisions_;
  last_ms_ = decision_ms;
  longest_ms_ = std::max(longest_ms_, decision_ms);
}

void PlannerDiagnostics::failed(const std::string& service, const std::string& what) {
  std::lock_guard<std::mutex> lock(mutex_);
  ++failures_;
  faults_[service] = what;
}

void PlannerDiagnostics::answered(const std::string& service) {
  std::lock_guard<std::mutex> lock(mutex_);
  faults_.erase(service);
}

/// Out of memory it may be that even this cannot be told.
void PlannerDiagnostics::update() noexcept {
  try {
    updater_.force_update();
  } catch (const std::exception&) {
  }
}

void PlannerDiagnostics::reportPallet(diagnostic_updater::DiagnosticStatusWrapper& status) {
  std::lock_guard<std::mutex> lock(mutex_);
  status.add("journal", journal_.empty() ? "none: a restart forgets the pallet" : journal_);
  if (state_.is_open == 0) {
    status.summary(DiagnosticStatus::OK, "no pallet is open");
    return;
  }
  std::size_t total = 0;
  std::size_t discarded = 0;
  for (const auto& line : state_.order) total += line.count;
  for (const auto count : state_.discarded) discarded += count;
  status.summaryf(DiagnosticStatus::OK, "pallet %s: %zu of %zu placed", state_.pallet_id.c_str(),
                  state_.placements.size(), total);
  status.add("discarded", discarded);
  status.add("revision", state_.revision);
  status.addf("utilization [%]", "%.1f", kPercent * state_.utilization);
  if (state_.has_pending != 0) status.add("decision to be reported", state_.pending_decision_id);
}

void PlannerDiagnostics::reportServices(diagnostic_updater::DiagnosticStatusWrapper& status) {
  std::lock_guard<std::mutex> lock(mutex_);
  status.summary(DiagnosticStatus::OK, "services answer");
  for (const auto& [service, what] : faults_) {
    status.summary(DiagnosticStatus::ERROR, service + ": " + what);
  }
  status.add("calls that broke off", failures_);
  status.add("decisions", decisions_);
  if (decisions_ == 0) return;
  status.addf("time of the last decision [ms]", "%.1f", last_ms_);
  status.addf("time of the longest decision [ms]", "%.1f", longest_ms_);
}

}  // namespace mixed_palletizing::adapters
