// What /diagnostics says about the planner.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/steady_timer.h>

#include <mixed_palletizing/PalletState.h>

namespace mixed_palletizing::adapters {

/// Publishes once a second, on the node's own threads. Thread safe.
class PlannerDiagnostics {
 public:
  /// `journal`: its file, empty when the pallet is in memory only.
  PlannerDiagnostics(const ros::NodeHandle& private_node, std::string journal);

  void show(const PalletState& state);
  void decided(double decision_ms);

  /// A service broke off; that is an error until the same service answers again.
  void failed(const std::string& service, const std::string& what);
  void answered(const std::string& service);

 private:
  void update() noexcept;
  void reportPallet(diagnostic_updater::DiagnosticStatusWrapper& status);
  void reportServices(diagnostic_updater::DiagnosticStatusWrapper& status);

  const std::string journal_;
  std::mutex mutex_;  // guards the next six
  PalletState state_;
  std::uint64_t decisions_ = 0;
  double last_ms_ = 0.0;
  double longest_ms_ = 0.0;
  std::uint64_t failures_ = 0;
  std::map<std::string, std::string> faults_;  // of services whose last call broke off
  diagnostic_updater::Updater updater_;
  ros::SteadyTimer timer_;  // last: calls the tasks, which use the members above
};

}  // namespace mixed_palletizing::adapters
