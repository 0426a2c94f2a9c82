#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <mixed_palletizing/planning/session_state.hpp>

#include "candidates.hpp"

namespace mixed_palletizing::planning {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("SessionState::apply: " + why);
}

/// The available items (indices) that a kDiscarded report takes out of the order.
std::vector<std::size_t> discardedItems(const PickDecided& decided, const PickReported& event) {
  if (!event.discarded.empty()) return event.discarded;
  if (decided.reply.decision.chosen) return {*decided.reply.decision.chosen};
  std::vector<std::size_t> all(decided.available.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

std::optional<packing::Placement> plannedPlacement(const Decision& decision) {
  if (!decision.chosen) return std::nullopt;
  return decision.options[*decision.chosen].placement;
}

Situation OpenPallet::situation(const std::vector<int>& available) const {
  return situationOf(pallet, order, knowledge, taken, available);
}

std::string OpenPallet::problemOf(const std::vector<int>& available) const {
  if (knowledge.kind == Knowledge::kSet) return availableProblem(available, remaining);
  const std::vector<int> any_number(order.types.size(), static_cast<int>(available.size()));
  return availableProblem(available, any_number);
}

void OpenPallet::take(int type, int count) {
  const auto t = static_cast<std::size_t>(type);
  taken[t] += count;
  remaining[t] = std::max(0, order.counts[t] - taken[t]);
}

void SessionState::apply(const SessionEvent& event) {
  std::visit([this](const auto& e) { on(e); }, event);
}

void SessionState::on(const PalletStarted& event) {
  if (open_) refuse("pallet '" + open_->id + "' is open");
  const std::vector<std::string> found = problems(event.order, event.knowledge);
  if (!found.empty()) refuse(found.front());
  const std::vector<int> none(event.order.counts.size(), 0);
  open_ = OpenPallet{event.pallet_id,
                     event.order,
                     event.knowledge,
                     packing::PalletState(event.order),
                     none,
                     event.order.counts,
                     none,
                     {},
                     {},
                     {}};
  reports_.clear();
  ++revision_;
}

void SessionState::on(const PickDecided& event) {
  if (!open_) refuse("no pallet is open");
  if (event.reply.decision_id != next_decision_id_) {
    refuse("decision " + std::to_string(event.reply.decision_id) + ", " + std::to_string(next_decision_id_) +
           " is next");
  }
  const std::string problem = open_->problemOf(event.available);
  if (!problem.empty()) refuse(problem);
  const Decision& decision = event.reply.decision;
  if (decision.options.size() != event.available.size() ||
      (decision.chosen && *decision.chosen >= event.available.size())) {
    refuse("decision " + std::to_string(event.reply.decision_id) + " does not fit its available items");
  }
  open_->decisions.push_back(std::make_shared<const PickDecided>(event));
  if (open_->decisions.size() > kMaxDecisions) open_->decisions.pop_front();
  open_->decision_ms.push_back(event.decision_ms);
  ++next_decision_id_;
}

void SessionState::on(const PickReported& event) {
  const PickDecided* decided = decision(event.decision_id);
  if (decided == nullptr) refuse("decision " + std::to_string(event.decision_id) + " is not open");
  OpenPallet::Change change{event.decision_id, {}};
  if (event.outcome == PickOutcome::kPlaced) {
    const std::optional<std::size_t> chosen = decided->reply.decision.chosen;
    if (!chosen) refuse("decision " + std::to_string(event.decision_id) + " chose nothing to place");
    const packing::Placement placement =
        event.measured ? *event.measured : decided->reply.decision.options[*chosen].placement;
    if (placement.type != decided->available[*chosen]) refuse("the measured box is of another type");
    open_->pallet.place(placement);
    open_->take(placement.type, 1);
  } else if (event.outcome == PickOutcome::kDiscarded) {
    for (const std::size_t item : discardedItems(*decided, event)) {
      if (item >= decided->available.size()) refuse("discarded item " + std::to_string(item));
      change.discarded_types.push_back(decided->available[item]);
    }
    const std::string problem = open_->problemOf(change.discarded_types);
    if (!problem.empty()) refuse("discarded " + problem);
    for (const int type : change.discarded_types) {
      open_->take(type, 1);
      ++open_->discarded[static_cast<std::size_t>(type)];
    }
  }
  reports_[event.decision_id] = std::make_shared<const ReportedPick>(
      ReportedPick{event, decided->notes, plannedPlacement(decided->reply.decision)});
  open_->decisions.clear();
  if (event.outcome == PickOutcome::kFailed) return;
  open_->changes.push_back(std::move(change));
  ++revision_;
}

void SessionState::on(const LastUndone&) {
  if (!open_ || open_->changes.empty()) refuse("nothing to take back");
  const OpenPallet::Change& change = open_->changes.back();
  if (change.discarded_types.empty()) {
    open_->take(open_->pallet.placements().back().type, -1);
    open_->pallet.undo();
  }
  for (const int type : change.discarded_types) {
    open_->take(type, -1);
    --open_->discarded[static_cast<std::size_t>(type)];
  }
  reports_.erase(change.decision_id);
  open_->changes.pop_back();
  open_->decisions.clear();
  ++revision_;
}

void SessionState::on(const PalletClosed&) {
  if (!open_) refuse("no pallet is open");
  open_.reset();
  ++revision_;
}

const PickDecided* SessionState::decision(std::uint64_t decision_id) const {
  if (!open_) return nullptr;
  for (const auto& decided : open_->decisions) {
    if (decided->reply.decision_id == decision_id) return decided.get();
  }
  return nullptr;
}

const ReportedPick* SessionState::report(std::uint64_t decision_id) const {
  const auto found = reports_.find(decision_id);
  return found == reports_.end() ? nullptr : found->second.get();
}

}  // namespace mixed_palletizing::planning
