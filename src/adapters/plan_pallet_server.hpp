// The action plan_pallet: the packing of a whole order whose boxes can be taken in any sequence.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>

#include <mixed_palletizing/PlanPalletAction.h>
#include <mixed_palletizing/adapters/planner_options.hpp>
#include <mixed_palletizing/planning/pallet_session.hpp>

namespace mixed_palletizing::adapters {

/// Runs in a thread of its own and works on copies, so that the session stays free meanwhile.
class PlanPalletServer {
 public:
  PlanPalletServer(ros::NodeHandle& node, const PickPlannerOptions& options, std::mutex& session_mutex,
                   const planning::PalletSession& session);

 private:
  /// What is to be planned.
  struct Task {
    packing::Order order;
    packing::PalletState pallet;
    std::vector<int> items;
  };

  void execute(const PlanPalletGoalConstPtr& goal);
  void plan(const PlanPalletGoal& goal, PlanPalletResult& result);
  std::optional<Task> taskOf(const PlanPalletGoal& goal, PlanPalletResult& result);

  const PickPlannerOptions& options_;
  std::mutex& session_mutex_;
  const planning::PalletSession& session_;
  actionlib::SimpleActionServer<mixed_palletizing::PlanPalletAction> server_;
};

}  // namespace mixed_palletizing::adapters
