// The part of PlannerServer that chooses picks and takes their reports.
#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include <mixed_palletizing/PickDecision.h>
#include <mixed_palletizing/adapters/pallet_messages.hpp>
#include <mixed_palletizing/adapters/planner_server.hpp>

#include "pick_request.hpp"
#include "planner_diagnostics.hpp"
#include "planner_status.hpp"

namespace mixed_palletizing::adapters {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kMillisecondsPerSecond = 1000.0;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Turns the placement to the axes of the chosen box when that was detected.
void alignWithBox(const ChooseNextPickRequest& request, std::size_t index, Placement& placement) {
  if (request.boxes.empty()) return;
  const auto& size = request.boxes[index].size;
  alignPose(placement, {size.x, size.y, size.z});
}

std::vector<std::array<double, 3>> detectedSizes(const ChooseNextPickRequest& request,
                                                 const std::vector<std::size_t>& indices) {
  std::vector<std::array<double, 3>> sizes;
  if (request.boxes.empty()) return sizes;
  for (const std::size_t index : indices) {
    const auto& size = request.boxes[index].size;
    sizes.push_back({size.x, size.y, size.z});
  }
  return sizes;
}

std::uint8_t statusOf(const planning::PickOption& option) {
  if (option.feasible) return PickOption::FEASIBLE;
  return option.looked_at ? PickOption::DOES_NOT_FIT : PickOption::NOT_LOOKED_AT;
}

std::optional<planning::PickOutcome> outcomeOf(std::uint8_t word) {
  switch (word) {
    case ReportPickRequest::PLACED:
      return planning::PickOutcome::kPlaced;
    case ReportPickRequest::DISCARDED:
      return planning::PickOutcome::kDiscarded;
    case ReportPickRequest::FAILED:
      return planning::PickOutcome::kFailed;
    default:
      return std::nullopt;
  }
}

PickDecision decisionOf(const ChooseNextPickRequest& request, const ChooseNextPickResponse& response) {
  PickDecision decision;
  decision.header = response.header;
  decision.request_id = request.request_id;
  decision.status = response.status;
  decision.message = response.message;
  decision.chosen_index = response.chosen_index;
  decision.decision_id = response.decision_id;
  decision.options = response.options;
  decision.decision_ms = response.decision_ms;
  decision.assumed = response.assumed;
  decision.pondered = response.pondered;
  return decision;
}

}  // namespace

bool PlannerServer::onChoose(ChooseNextPickRequest& request, ChooseNextPickResponse& response) {
  const Clock::time_point start = Clock::now();
  response.chosen_index = -1;
  guarded("choose_next_pick", *diagnostics_, response, [&] { choose(request, response); });
  response.decision_ms = millisecondsSince(start);
  if (response.options.empty()) return true;
  diagnostics_->decided(response.decision_ms);
  decision_publisher_.publish(decisionOf(request, response));
  return true;
}

void PlannerServer::choose(const ChooseNextPickRequest& request, ChooseNextPickResponse& response) {
  const double budget_s = request.time_budget > 0.0 ? request.time_budget : options_.time_budget_s;
  const Clock::time_point start = Clock::now();
  const std::string fault = faultOf(request, options_.max_available);
  std::lock_guard<std::mutex> lock(session_mutex_);
  response.header.frame_id = options_.pallet_frame;
  response.header.stamp = ros::Time::now();
  const auto refuse = [&](std::uint8_t status, const std::string& message) {
    response.status = status;
    response.message = message;
  };
  if (!session_.open())
    return refuse(ChooseNextPickResponse::NO_PALLET, "no pallet is open: call start_pallet");
  if (!fault.empty()) return refuse(ChooseNextPickResponse::BAD_REQUEST, fault);
  if (session_.complete()) {
    return refuse(ChooseNextPickResponse::ORDER_COMPLETE, "nothing of the order is left");
  }
  if (request.boxes.empty() && request.type_ids.empty()) {
    return refuse(ChooseNextPickResponse::BAD_REQUEST, "boxes: no box is available");
  }
  const IdentifiedBoxes boxes = identify(request, session_, options_.matching);
  response.options = boxes.options;
  if (boxes.types.empty()) return refuse(nothingIdentified(boxes), boxes.options.front().reason);
  // The budget counts from the call, the steady clock does not jump.
  const auto deadline =
      start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(budget_s));
  const auto stop = [deadline] { return Clock::now() >= deadline; };
  const planning::CallerNotes notes{boxes.request_index, detectedSizes(request, boxes.request_index)};
  const planning::ChooseReply reply =
      session_.choose(request.request_id, boxes.types, stop, millisecondsSince(start), notes,
                      budget_s * kMillisecondsPerSecond);
  answer(reply, boxes, request, response);
  if (reply.decision_id != 0) publishState();
}

void PlannerServer::answer(const planning::ChooseReply& reply, const IdentifiedBoxes& boxes,
                           const ChooseNextPickRequest& request, ChooseNextPickResponse& response) {
  response.status = codeOf(reply.status);
  response.message = reply.message;
  response.decision_id = reply.decision_id;
  response.assumed = reply.assumed;
  response.pondered = reply.pondered ? 1 : 0;
  for (std::size_t i = 0; i < reply.decision.options.size(); ++i) {
    const planning::PickOption& option = reply.decision.options[i];
    PickOption& message = response.options.at(boxes.request_index.at(i));
    message.status = statusOf(option);
    message.feasible = option.feasible ? 1 : 0;
    message.reason = option.reason;
    message.future_costs = option.future_costs;
    message.playouts = static_cast<std::uint32_t>(option.future.playouts);
    message.perfect_ratio = option.future.perfect_ratio;
    message.unpacked_ratio = option.future.unpacked_ratio;
    if (!option.feasible) continue;
    message.placement = toMessage(option.placement, *session_.order());
    setApproach(message.placement, lastStretch(option.placement));
    alignWithBox(request, boxes.request_index[i], message.placement);
  }
  if (reply.decision.chosen) {
    const std::size_t index = boxes.request_index.at(*reply.decision.chosen);
    response.chosen_index = static_cast<std::int32_t>(index);
    response.type_id = response.options[index].type_id;
    response.placement = response.options[index].placement;
  }
}

packing::Vec3 PlannerServer::lastStretch(const packing::Placement& placement) const {
  return planning::lastStretch(options_.approach, options_.planner.gripper, *session_.pallet(), placement);
}

bool PlannerServer::onReport(ReportPickRequest& request, ReportPickResponse& response) {
  return guarded("report_pick", *diagnostics_, response, [&] { report(request, response); });
}

std::optional<packing::Placement> PlannerServer::measured(
    const ReportPickRequest& request, const std::optional<planning::KnownDecision>& decision,
    ReportPickResponse& response) const {
  const bool given = request.outcome == ReportPickRequest::PLACED && request.has_actual_pose != 0;
  if (!given || !decision || !decision->planned) return std::nullopt;
  const MeasuredPlacement found = measuredPlacement(
      request.actual_pose, *decision->planned, options_.position_tolerance_m, options_.angle_tolerance_rad);
  if (!found.placement) {
    response.status = ReportPickResponse::INVALID_PLACEMENT;
    response.message = found.problem;
  }
  // Within tolerance the plan stands, so that repeating the report without the measurement is the same report.
  return found.placement == decision->planned ? std::nullopt : found.placement;
}

void PlannerServer::report(const ReportPickRequest& request, ReportPickResponse& response) {
  std::lock_guard<std::mutex> lock(session_mutex_);
  response.revision = session_.revision();
  const auto outcome = outcomeOf(request.outcome);
  if (!outcome) {
    response.status = ReportPickResponse::BAD_REQUEST;
    response.message =
        "outcome: " + std::to_string(request.outcome) + " is none of PLACED, DISCARDED, FAILED";
    return;
  }
  const std::optional<planning::KnownDecision> decision = session_.knownDecision(request.decision_id);
  std::vector<std::size_t> discarded(request.discarded.begin(), request.discarded.end());
  if (decision) {
    for (std::size_t& index : discarded) {
      // From the request's boxes to the identified ones; an index of another box stays out of range.
      const auto& known = decision->notes.request_index;
      index = static_cast<std::size_t>(std::find(known.begin(), known.end(), index) - known.begin());
    }
  }
  const auto placement = measured(request, decision, response);
  if (response.status == ReportPickResponse::INVALID_PLACEMENT) return;
  const planning::SessionReply reply = session_.report(request.decision_id, *outcome, placement, discarded);
  fill(reply, session_.revision(), response);
  if (placement && response.status == ReportPickResponse::BAD_REQUEST) {
    response.status = ReportPickResponse::INVALID_PLACEMENT;
  }
  if (response.status == ReportPickResponse::OK) publishState();
}

}  // namespace mixed_palletizing::adapters
