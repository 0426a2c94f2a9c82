#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>

#include <mixed_palletizing/planning/pallet_session.hpp>

#include "candidates.hpp"
#include "expected_worlds.hpp"
#include "report_check.hpp"

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

std::string decisionText(const Decision& decision, const std::vector<int>& available,
                         const packing::Order& order) {
  if (decision.chosen) {
    const packing::Placement& placement = decision.options[*decision.chosen].placement;
    return "'" + order.types[static_cast<std::size_t>(placement.type)].name + "' to " +
           text(placement.origin) + " mm";
  }
  std::set<std::string> reasons;
  std::set<int> told;
  for (std::size_t i = 0; i < available.size(); ++i) {
    const packing::ItemType& type = order.types[static_cast<std::size_t>(available[i])];
    if (told.insert(available[i]).second)
      reasons.insert("'" + type.name + "': " + decision.options[i].reason);
  }
  return "none of the available boxes fits: " + joined(reasons);
}

}  // namespace

PalletSession::PalletSession(const PlannerOptions& options, SessionState state, Recorder recorder)
    : options_(options), state_(std::move(state)), recorder_(std::move(recorder)) {
  const std::vector<std::string> found = problems(options);
  if (!found.empty()) throw std::invalid_argument("PalletSession: options: " + joined(found));
}

PalletSession::PalletSession(PalletSession&&) noexcept = default;
PalletSession::~PalletSession() = default;

void PalletSession::ponder() { ponderer_ = std::make_unique<Ponderer>(options_); }

SessionReply PalletSession::start(const std::string& pallet_id, const packing::Order& order, bool close_open,
                                  const OrderKnowledge& knowledge) {
  if (open() && !close_open) return {SessionStatus::kPalletOpen, "pallet '" + palletId() + "' is still open"};
  std::vector<std::string> found = problems(order, knowledge);
  if (pallet_id.empty()) found.emplace_back("pallet_id: '': must not be empty");
  if (!found.empty()) return {SessionStatus::kBadRequest, joined(found)};
  std::vector<SessionEvent> events;
  if (open()) events.emplace_back(PalletClosed{});
  events.emplace_back(PalletStarted{pallet_id, order, knowledge});
  record(events);
  options_.best.fitted.reset();
  if (ponderer_) ponderer_->forget();
  return {SessionStatus::kOk,
          "pallet '" + pallet_id + "': " + assumptionOf(state_.open()->situation({}), knowledge.kind)};
}

ChooseReply PalletSession::choose(const std::string& request_id, const std::vector<int>& available,
                                  const packing::StopCallback& stop, double elapsed_ms_of_caller,
                                  const CallerNotes& notes, double budget_ms) {
  const Clock::time_point start = Clock::now();
  ChooseReply reply;
  const auto answer = [&reply](ChooseStatus status, const std::string& message) -> const ChooseReply& {
    reply.status = status;
    reply.message = message;
    return reply;
  };
  const OpenPallet* open = state_.open();
  if (open == nullptr) return answer(ChooseStatus::kNoPallet, "no pallet is open");
  for (const auto& decided : open->decisions) {
    if (request_id.empty() || decided->request_id != request_id) continue;
    if (decided->available == available) return decided->reply;
    return answer(ChooseStatus::kConflict, "request '" + request_id + "' came before with other boxes");
  }
  if (complete()) {
    return answer(ChooseStatus::kOrderComplete, "every item of the order is placed or discarded");
  }
  if (available.empty()) return answer(ChooseStatus::kBadRequest, "available: no box is available");
  const std::string problem = open->problemOf(available);
  if (!problem.empty()) return answer(ChooseStatus::kBadRequest, problem);

  const Situation situation = open->situation(available);
  reply.assumed = assumptionOf(situation, open->knowledge.kind);
  if (auto known = ponderer_ ? ponderer_->take(situation, seed(), budget_ms, stop) : std::nullopt) {
    reply.decision = std::move(*known);
    reply.pondered = true;
  } else {
    if (ponderer_) options_.best.fitted = ponderer_->fitted();
    reply.decision = chooseNextPick(situation, options_, seed(), stop);
  }
  options_.best.fitted = reply.decision.fitted;
  reply.decision_id = state_.nextDecisionId();
  answer(reply.decision.chosen ? ChooseStatus::kPick : ChooseStatus::kNoneFits,
         decisionText(reply.decision, available, open->order));
  const std::chrono::duration<double, std::milli> elapsed = Clock::now() - start;
  std::vector<SessionEvent> events(1);  // a list in braces copies the options of thousands of boxes again
  events[0] = PickDecided{request_id, available, notes, reply, elapsed.count() + elapsed_ms_of_caller};
  record(events);
  budget_ms_ = budget_ms;
  ponderAfter(*state_.open()->decisions.back());
  return reply;
}

/// The seed follows the revision: the same situation of one pallet is decided the same way.
std::uint64_t PalletSession::seed() const {
  return revision() + (options_.method == PlanMethod::kBest ? options_.best.seed : options_.genetic.seed);
}

/// The robot is about to do what was decided.
void PalletSession::ponderAfter(const PickDecided& decided) {
  const std::optional<std::size_t> chosen = decided.reply.decision.chosen;
  if (!ponderer_ || !chosen) return;
  ponderer_->expect(expectedWorlds(*state_.open(), decided.reply.decision.options[*chosen].placement,
                                   without(decided.available, {*chosen}), seed() + 1),
                    budget_ms_, options_.best.fitted);
}

/// Something else than the decision became of it.
void PalletSession::ponderAgain(const PickReported& event, const std::vector<int>& available,
                                std::optional<std::size_t> chosen) {
  if (!ponderer_) return;
  ponderer_->expect(worldsAfter(event, *state_.open(), available, chosen, seed()), budget_ms_,
                    ponderer_->fitted());
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
  const std::vector<int> available = decided->available;
  const std::optional<std::size_t> chosen = decided->reply.decision.chosen;
  const bool as_expected = outcome == PickOutcome::kPlaced && !placement;
  record({event});
  if (!as_expected) ponderAgain(event, available, chosen);
  return {};
}

SessionReply PalletSession::undoLast() {
  if (!open()) return noPallet();
  if (state_.open()->changes.empty())
    return {SessionStatus::kNothingToUndo, "nothing was placed or discarded"};
  record({LastUndone{}});
  if (ponderer_) ponderer_->forget();
  return {};
}

SessionReply PalletSession::close(PalletSummary& summary) {
  if (!open()) return noPallet();
  summary = this->summary();
  record({PalletClosed{}});
  if (ponderer_) ponderer_->forget();
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

const OrderKnowledge* PalletSession::knowledge() const {
  return open() ? &state_.open()->knowledge : nullptr;
}

bool PalletSession::complete() const {
  if (!open() || state_.open()->knowledge.kind != Knowledge::kSet) return false;
  const std::vector<int>& left = state_.open()->remaining;
  return std::all_of(left.begin(), left.end(), [](int count) { return count == 0; });
}

std::vector<double> PalletSession::expected() const {
  return open() ? state_.open()->situation({}).forecast : std::vector<double>();
}

std::vector<int> PalletSession::discarded() const {
  return open() ? state_.open()->discarded : std::vector<int>();
}

std::uint64_t PalletSession::revision() const { return state_.revision(); }

const PickDecided* PalletSession::pendingDecision() const {
  return open() && !state_.open()->decisions.empty() ? state_.open()->decisions.back().get() : nullptr;
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

}  // namespace mixed_palletizing::planning
