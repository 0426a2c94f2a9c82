#include <exception>
#include <utility>

#include <ros/console.h>
#include <visualization_msgs/MarkerArray.h>

#include <mixed_palletizing/PickDecision.h>
#include <mixed_palletizing/adapters/markers.hpp>
#include <mixed_palletizing/adapters/names.hpp>
#include <mixed_palletizing/adapters/pallet_messages.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>
#include <mixed_palletizing/adapters/planner_server.hpp>

#include "plan_pallet_server.hpp"
#include "planner_diagnostics.hpp"
#include "planner_status.hpp"

namespace mixed_palletizing::adapters {
namespace {

std::unique_ptr<planning::PalletJournal> openJournal(const JournalFileOptions& options,
                                                     const std::string& node_name) {
  const std::string path = journalPath(options, node_name);
  if (path.empty()) return nullptr;
  return std::make_unique<planning::PalletJournal>(path, options.keep_pallets);
}

planning::PalletSession openSession(const planning::PlannerOptions& options,
                                    planning::PalletJournal* journal) {
  if (journal == nullptr) return planning::PalletSession(options);
  return planning::PalletSession(
      options, journal->restore(),
      [journal](const auto& before, const auto& events) { journal->append(before, events); });
}

}  // namespace

PlannerServer::PlannerServer(const ros::NodeHandle& private_node)
    : options_(readPickPlannerOptions(parameterTree(private_node))),
      node_(private_node),
      journal_(openJournal(options_.journal, node_.getNamespace())),
      session_(openSession(options_.planner, journal_.get())),
      state_publisher_(node_.advertise<PalletState>(names::kPalletState, 1, true)),
      markers_publisher_(node_.advertise<visualization_msgs::MarkerArray>(names::kPalletMarkers, 1, true)),
      decision_publisher_(node_.advertise<PickDecision>(names::kLastDecision, 1, true)) {
  diagnostics_ =
      std::make_unique<PlannerDiagnostics>(node_, journalPath(options_.journal, node_.getNamespace()));
  if (options_.ponder) session_.ponder();
  if (session_.open()) {
    ROS_INFO_STREAM("pallet '" << session_.palletId() << "' goes on at revision " << session_.revision()
                               << ": " << session_.pallet()->placements().size() << " boxes stand on it");
  }
  publishState();
  plan_pallet_ = std::make_unique<PlanPalletServer>(node_, options_, session_mutex_, session_);
  services_ = {node_.advertiseService(names::kStartPallet, &PlannerServer::onStart, this),
               node_.advertiseService(names::kChooseNextPick, &PlannerServer::onChoose, this),
               node_.advertiseService(names::kReportPick, &PlannerServer::onReport, this),
               node_.advertiseService(names::kUndoLast, &PlannerServer::onUndo, this),
               node_.advertiseService(names::kGetPalletState, &PlannerServer::onGetState, this),
               node_.advertiseService(names::kClosePallet, &PlannerServer::onClose, this)};
}

PlannerServer::~PlannerServer() = default;

bool PlannerServer::onStart(StartPalletRequest& request, StartPalletResponse& response) {
  return guarded("start_pallet", *diagnostics_, response, [&] {
    const ReadOrder read = readOrder({request.size, request.order, request.gap, request.min_support_ratio,
                                      request.knowledge, request.expected});
    std::lock_guard<std::mutex> lock(session_mutex_);
    response.revision = session_.revision();
    if (!read.problems.empty()) {
      response.status = StartPalletResponse::BAD_REQUEST;
      for (const auto& line : read.problems)
        response.message += (response.message.empty() ? "" : "; ") + line;
      return;
    }
    const planning::SessionReply reply =
        session_.start(request.pallet_id, read.order, request.close_open != 0, read.knowledge);
    fill(reply, session_.revision(), response);
    if (response.status != StartPalletResponse::OK) return;
    ROS_INFO_STREAM("pallet '" << request.pallet_id << "' started: " << read.order.itemCount() << " boxes of "
                               << read.order.types.size() << " types");
    publishState();
  });
}

bool PlannerServer::onUndo(UndoLastRequest&, UndoLastResponse& response) {
  return guarded("undo_last", *diagnostics_, response, [&] {
    std::lock_guard<std::mutex> lock(session_mutex_);
    const planning::SessionReply reply = session_.undoLast();
    fill(reply, session_.revision(), response);
    if (reply.ok()) publishState();
  });
}

bool PlannerServer::onGetState(GetPalletStateRequest&, GetPalletStateResponse& response) {
  std::lock_guard<std::mutex> lock(state_mutex_);
  response.state = state_;
  const bool is_open = state_.is_open != 0;
  response.status = is_open ? GetPalletStateResponse::OK : GetPalletStateResponse::NO_PALLET;
  response.message = is_open ? "" : "no pallet is open";
  return true;
}

bool PlannerServer::onClose(ClosePalletRequest&, ClosePalletResponse& response) {
  return guarded("close_pallet", *diagnostics_, response, [&] {
    std::lock_guard<std::mutex> lock(session_mutex_);
    planning::PalletSummary summary;
    const planning::SessionReply reply = session_.close(summary);
    response.status = codeOf(reply.status);
    response.message = reply.message;
    if (!reply.ok()) return;
    response.summary = toMessage(summary);
    publishState();
  });
}

void PlannerServer::publishState() {
  PalletState state = toMessage(session_);
  if (state.has_pending != 0) {
    setApproach(state.pending,
                lastStretch(*planning::plannedPlacement(session_.pendingDecision()->reply.decision)));
  }
  state.header.frame_id = options_.pallet_frame;
  state.header.stamp = ros::Time::now();
  state_publisher_.publish(state);
  markers_publisher_.publish(palletMarkers(state));
  diagnostics_->show(state);
  std::lock_guard<std::mutex> lock(state_mutex_);
  state_ = std::move(state);
}

}  // namespace mixed_palletizing::adapters
