// The planner at the ROS border: services, action and latched topics over the session of one pallet.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include <mixed_palletizing/ChooseNextPick.h>
#include <mixed_palletizing/ClosePallet.h>
#include <mixed_palletizing/GetPalletState.h>
#include <mixed_palletizing/ReportPick.h>
#include <mixed_palletizing/StartPallet.h>
#include <mixed_palletizing/UndoLast.h>
#include <mixed_palletizing/adapters/planner_options.hpp>
#include <mixed_palletizing/planning/pallet_journal.hpp>
#include <mixed_palletizing/planning/pallet_session.hpp>

namespace mixed_palletizing::adapters {

class PlanPalletServer;
class PlannerDiagnostics;
struct IdentifiedBoxes;

/// Services answer a status and a message, whatever comes in; no callback lets an exception out. Calls that
/// change or search wait for each other; get_pallet_state answers at once.
class PlannerServer {
 public:
  /// Names are private to `node`. Goes on with the pallet of the journal. Throws std::invalid_argument with all
  /// wrong parameters, planning::JournalError when the journal cannot be used.
  explicit PlannerServer(const ros::NodeHandle& private_node);
  ~PlannerServer();

 private:
  bool onStart(StartPalletRequest& request, StartPalletResponse& response);
  bool onChoose(ChooseNextPickRequest& request, ChooseNextPickResponse& response);
  bool onReport(ReportPickRequest& request, ReportPickResponse& response);
  bool onUndo(UndoLastRequest& request, UndoLastResponse& response);
  bool onGetState(GetPalletStateRequest& request, GetPalletStateResponse& response);
  bool onClose(ClosePalletRequest& request, ClosePalletResponse& response);

  void choose(const ChooseNextPickRequest& request, ChooseNextPickResponse& response);
  void answer(const planning::ChooseReply& reply, const IdentifiedBoxes& boxes,
              const ChooseNextPickRequest& request, ChooseNextPickResponse& response);
  packing::Vec3 lastStretch(const packing::Placement& placement) const;
  void report(const ReportPickRequest& request, ReportPickResponse& response);
  std::optional<packing::Placement> measured(const ReportPickRequest& request,
                                             const std::optional<planning::KnownDecision>& decision,
                                             ReportPickResponse& response) const;
  void publishState();

  const PickPlannerOptions options_;
  ros::NodeHandle node_;
  std::mutex session_mutex_;                          // guards journal_ and session_
  std::unique_ptr<planning::PalletJournal> journal_;  // null: in memory only
  planning::PalletSession session_;

  std::mutex state_mutex_;  // guards state_
  PalletState state_;

  std::unique_ptr<PlannerDiagnostics> diagnostics_;
  ros::Publisher state_publisher_;
  ros::Publisher markers_publisher_;
  ros::Publisher decision_publisher_;
  std::vector<ros::ServiceServer> services_;
  std::unique_ptr<PlanPalletServer> plan_pallet_;
};

}  // namespace mixed_palletizing::adapters
