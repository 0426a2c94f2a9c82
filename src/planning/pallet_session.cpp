#include <algorithm>
#include <chrono>
#include <numeric>
#include <set>
#include <stdexcept>

#include <mixed_palletizing/planning/pallet_session.hpp>

#include "candidates.hpp"
#include "pallet_stability.hpp"

namespace mixed_palletizing::planning {
namespace {

using Clock = std::chrono::steady_clock;

template <typename Strings>
std::string joined(const Strings& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "; ") + line;
  return text;
}

std::string text(const packing::Vec3& v) {
  return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
}

SessionReply noPallet() { return {SessionStatus::kNoPallet, "no pallet is open"}; }

bool sameReport(const PickReported& a, const PickReported& b) {
  return a.outcome == b.outcome && a.measured == b.measured && a.discarded == b.discarded;
}

/// Why the report does not suit its decision; empty when it does.
std::string reportProblem(const PickDecided& decided, const PickReported& report, const OpenPallet& open) {
  if (report.outcome != PickOutcome::kPlaced && report.measured) {
    return "a placement was reported for a box that was not placed";
  }
  if (report.outcome != PickOutcome::kDiscarded && !report.discarded.empty()) {
    return "items were reported as discarded, but the outcome is another";
  }
  const std::set<std::size_t> distinct(report.discarded.begin(), report.discarded.end());
  if (distinct.size() != report.discarded.size()) return "an item was reported as discarded twice";
  for (const std::size_t item : distinct) {
    if (item < decided.available.size()) continue;
    return "discarded item " + std::to_string(item) + " of " + std::to_string(decided.available.size()) +
           " available";
  }
  if (report.outcome != PickOutcome::kPlaced) return {};
  if (!decided.reply.decision.chosen) return "the decision chose no box, so none can have been placed";
  if (!report.measured) return {};
  const int type = decided.available[*decided.reply.decision.chosen];
  if (report.measured->type != type) {
    return "the measured box is of type " + std::to_string(report.measured->type) +
           ", the decision chose type " + std::to_string(type);
  }
  const packing::ItemType& item = open.order.types[static_cast<std::size_t>(type)];
  const std::vector<packing::Vec3> sizes = packing::orientations(item);
  if (std::find(sizes.begin(), sizes.end(), report.measured->size) == sizes.end()) {
    return "'" + item.name + "' may not stand with the size " + text(report.measured->size) + " mm";
  }
  return open.pallet.whyNot(*report.measured);
}

std::string decisionText(const Decision& decision, const std::vector<int>& available,
                         const packing::Order& order) {
  if (decision.chosen) {
    const packing::Placement& placement = decision.options[*decision.chosen].placement;
    return "'" + order.types[static_cast<std::size_t>(placement.type)].name + "' to " +
           text(placement.origin) + " mm";
  }
  std::set<std::string> reasons;
  for (std::size_t i = 0; i < available.size(); ++i) {
    reasons.insert("'" + order.types[static_cast<std::size_t>(available[i])].name +
                   "': " + decision.options[i].reason);
  }
  return "none of the available boxes fits: " + joined(reasons);
}

}  // namespace

PalletSession::PalletSession(const PlannerOptions& options, SessionState state, Recorder recorder)
    : options_(options), state_(std::move(state)), recorder_(std::move(recorder)) {
  const std::vector<std::string> found = problems(options);
  if (!found.empty()) throw std::invalid_argument("PalletSession: options: " + joined(found));
}

SessionReply PalletSession::start(const std::string& pallet_id, const packing::Order& order,
                                  bool close_open) {
  if (open() && !close_open) return {SessionStatus::kPalletOpen, "pallet '" + palletId() + "' is still open"};
  std::vector<std::string> found = problems(order);
  if (pallet_id.empty()) found.emplace_back("pallet_id: '': must not be empty");
  if (!found.empty()) return {SessionStatus::kBadRequest, joined(found)};
  std::vector<SessionEvent> events;
  if (open()) events.emplace_back(PalletClosed{});
  events.emplace_back(PalletStarted{pallet_id, order});
  record(events);
  return {SessionStatus::kOk,
          "pallet '" + pallet_id + "' with " + std::to_string(order.itemCount()) + " items"};
}

ChooseReply PalletSession::choose(const std::string& request_id, const std::vector<int>& available,
                                  const packing::StopCallback& stop, double elapsed_ms_of_caller,
                                  const CallerNotes& notes) {
  const Clock::time_point start = Clock::now();
  ChooseReply reply;
  const auto answer = [&reply](ChooseStatus status, const std::string& message) {
    reply.status = status;
    reply.message = message;
    return reply;
  };
  const OpenPallet* open = state_.open();
  if (open == nullptr) return answer(ChooseStatus::kNoPallet, "no pallet is open");
  for (const PickDecided& decided : open->decisions) {
    if (request_id.empty() || decided.request_id != request_id) continue;
    if (decided.available == available) return decided.reply;
    return answer(ChooseStatus::kConflict, "request '" + request_id + "' came before with other boxes");
  }
  if (std::accumulate(open->remaining.begin(), open->remaining.end(), 0) == 0) {
    return answer(ChooseStatus::kOrderComplete, "every item of the order is placed or discarded");
  }
  if (available.empty()) return answer(ChooseStatus::kBadRequest, "available: no box is available");
  const std::string problem = availableProblem(available, open->remaining);
  if (!problem.empty()) return answer(ChooseStatus::kBadRequest, problem);

  const Situation situation{open->pallet, open->order.types, available, open->remaining};
  // The seed follows the revision: the same situation of one pallet is decided the same way.
  const std::uint64_t seed =
      options_.method == PlanMethod::kBest ? options_.best.seed : options_.genetic.seed;
  reply.decision = chooseNextPick(situation, options_, seed + revision(), stop);
  reply.decision_id = state_.nextDecisionId();
  answer(reply.decision.chosen ? ChooseStatus::kPick : ChooseStatus::kNoneFits,
         decisionText(reply.decision, available, open->order));
  const std::chrono::duration<double, std::milli> elapsed = Clock::now() - start;
  record({PickDecided{request_id, available, notes, reply, elapsed.count() + elapsed_ms_of_caller}});
  return reply;
}

SessionReply PalletSession::report(std::uint64_t decision_id, PickOutcome outcome,
                                   const std::optional<packing::Placement>& placement,
                                   const std::vector<std::size_t>& discarded) {
  const PickReported event{decision_id, outcome, placement, discarded};
  if (const ReportedPick* before = state_.report(decision_id)) {
    if (sameReport(before->report, event)) return {SessionStatus::kOk, "reported before"};
    return {SessionStatus::kConflict,
            "decision " + std::to_string(decision_id) + " was reported otherwise before"};
  }
  if (!open()) return noPallet();
  const PickDecided* decided = state_.decision(decision_id);
  if (decided == nullptr) {
    return {SessionStatus::kUnknownDecision,
            "decision " + std::to_string(decision_id) +
                (decision_id == 0 || decision_id >= state_.nextDecisionId() ? " was never made"
                                                                            : " is out of date")};
  }
  const std::string problem = reportProblem(*decided, event, *state_.open());
  if (!problem.empty()) return {SessionStatus::kBadRequest, problem};
  record({event});
  return {};
}

SessionReply PalletSession::undoLast() {
  if (!open()) return noPallet();
  if (state_.open()->changes.empty())
    return {SessionStatus::kNothingToUndo, "nothing was placed or discarded"};
  record({LastUndone{}});
  return {};
}

SessionReply PalletSession::close(PalletSummary& summary) {
  if (!open()) return noPallet();
  summary = this->summary();
  record({PalletClosed{}});
  return {};
}

const packing::PalletState* PalletSession::pallet() const {
  return open() ? &state_.open()->pallet : nullptr;
}

const packing::Order* PalletSession::order() const { return open() ? &state_.open()->order : nullptr; }

const std::string& PalletSession::palletId() const {
  static const std::string kNone;
  return open() ? state_.open()->id : kNone;
}

std::vector<int> PalletSession::remaining() const {
  return open() ? state_.open()->remaining : std::vector<int>();
}

std::vector<int> PalletSession::discarded() const {
  return open() ? state_.open()->discarded : std::vector<int>();
}

std::uint64_t PalletSession::revision() const { return state_.revision(); }

const PickDecided* PalletSession::pendingDecision() const {
  return open() && !state_.open()->decisions.empty() ? &state_.open()->decisions.back() : nullptr;
}

std::optional<KnownDecision> PalletSession::knownDecision(std::uint64_t decision_id) const {
  if (const PickDecided* decided = state_.decision(decision_id)) {
    return KnownDecision{decided->notes, plannedPlacement(decided->reply.decision)};
  }
  if (const ReportedPick* reported = state_.report(decision_id)) {
    return KnownDecision{reported->notes, reported->planned};
  }
  return std::nullopt;
}

/// The events are tried on a copy first: what is recorded can be applied.
void PalletSession::record(const std::vector<SessionEvent>& events) {
  SessionState next = state_;
  for (const SessionEvent& event : events) next.apply(event);
  if (recorder_) recorder_(state_, events);
  state_ = std::move(next);
}

PalletSummary PalletSession::summary() const {
  PalletSummary summary;
  const OpenPallet* open = state_.open();
  if (open == nullptr) return summary;
  summary.pallet_id = open->id;
  summary.placed = static_cast<int>(open->pallet.placements().size());
  summary.discarded = std::accumulate(open->discarded.begin(), open->discarded.end(), 0);
  summary.remaining = std::accumulate(open->remaining.begin(), open->remaining.end(), 0);
  summary.utilization = open->pallet.utilization();
  summary.center_of_gravity_mm = centreOfGravity(open->pallet, open->order);
  summary.min_support_ratio = leastSupport(open->pallet);
  summary.gravity_margin_mm = gravityMargin(open->pallet, summary.center_of_gravity_mm);
  for (std::size_t t = 0; t < open->order.types.size(); ++t) {
    summary.unpacked_volume_ratio += static_cast<double>(open->discarded[t] + open->remaining[t]) *
                                     static_cast<double>(packing::volume(open->order.types[t].size));
  }
  summary.unpacked_volume_ratio /= static_cast<double>(packing::volume(open->order.rules.size));
  std::vector<double> times = open->decision_ms;
  std::sort(times.begin(), times.end());
  summary.decisions = static_cast<int>(times.size());
  if (times.empty()) return summary;
  summary.median_decision_ms = times[(times.size() - 1) / 2];
  summary.p99_decision_ms = times[(times.size() * 99 + 99) / 100 - 1];
  summary.max_decision_ms = times.back();
  return summary;
}

}  // namespace mixed_palletizing::planning
