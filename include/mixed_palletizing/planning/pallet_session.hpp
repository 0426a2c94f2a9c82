// The session of one pallet: what is ordered, placed, discarded and decided.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>
#include <mixed_palletizing/planning/pallet_summary.hpp>
#include <mixed_palletizing/planning/ponderer.hpp>
#include <mixed_palletizing/planning/session_reply.hpp>
#include <mixed_palletizing/planning/session_state.hpp>

namespace mixed_palletizing::planning {

/// What a report of a decision refers to.
struct KnownDecision {
  CallerNotes notes;
  std::optional<packing::Placement> planned;
};

/// One pallet from start to close. Every call answers a status and leaves the state unchanged when it
/// refuses. Not thread safe.
class PalletSession {
 public:
  /// Called with every change before it takes effect and is answered: makes it durable, all events or none.
  /// When it throws, nothing has changed.
  using Recorder = std::function<void(const SessionState& before, const std::vector<SessionEvent>& events)>;

  /// Goes on from `state`. Throws std::invalid_argument with every line of problems(options).
  explicit PalletSession(const PlannerOptions& options, SessionState state = {}, Recorder recorder = {});
  PalletSession(PalletSession&& other) noexcept;
  ~PalletSession();

  /// From now on thinks about the next decision between the calls, in a thread of its own (Ponderer).
  void ponder();

  /// kPalletOpen while another pallet is open, unless `close_open`; kBadRequest with every line of
  /// problems(order, knowledge), or for an empty id.
  SessionReply start(const std::string& pallet_id, const packing::Order& order, bool close_open,
                     const OrderKnowledge& knowledge = {});

  /// Decides which of `available` (type indices) to pick next. The same request_id with the same items gets
  /// the same answer until something is reported or taken back; an empty id is never remembered. Changes
  /// neither the pallet nor the order. `elapsed_ms_of_caller` [ms] is added to the decision's time in the
  /// summary; `notes` are kept with the decision; `budget_ms` is the time that `stop` gives: what was pondered for
  /// less is not used.
  ChooseReply choose(const std::string& request_id, const std::vector<int>& available,
                     const packing::StopCallback& stop, double elapsed_ms_of_caller = 0.0,
                     const CallerNotes& notes = {}, double budget_ms = 0.0);

  /// What became of a decision.
  /// kPlaced: the box stands at the planned placement, or at `placement` when the robot measured another;
  /// that one is refused with the rule it breaks (kBadRequest).
  /// kDiscarded: the items at `discarded` (indices in the decision's available list) leave the order; empty =
  /// the chosen one, or all of a decision where none fits.
  /// kFailed: nothing happened, all items are still to come.
  /// Repeating a report is harmless; the same decision with another report is kConflict.
  SessionReply report(std::uint64_t decision_id, PickOutcome outcome,
                      const std::optional<packing::Placement>& placement,
                      const std::vector<std::size_t>& discarded);

  /// Takes back the last report of a placed or discarded box.
  SessionReply undoLast();

  /// Ends the pallet; `summary` is written when the reply is ok.
  SessionReply close(PalletSummary& summary);

  bool open() const { return state_.open() != nullptr; }
  const packing::PalletState* pallet() const;  ///< null when no pallet is open
  const packing::Order* order() const;         ///< null when no pallet is open
  const std::string& palletId() const;         ///< empty when no pallet is open
  const OrderKnowledge* knowledge() const;     ///< null when no pallet is open
  bool complete() const;                       ///< nothing of a known order is left
  std::vector<int> remaining() const;          ///< count per type of those sure to come
  std::vector<double> expected() const;        ///< per type, beside them; empty when the set is known
  std::vector<int> discarded() const;          ///< count per type
  std::uint64_t revision() const;              ///< grows with every change
  const PickDecided* pendingDecision() const;  ///< the last one, not yet reported; null when there is none
  std::optional<KnownDecision> knownDecision(std::uint64_t decision_id) const;  ///< open or reported
  PalletSummary summary() const;  ///< so far; empty when no pallet is open

 private:
  void record(const std::vector<SessionEvent>& events);
  std::uint64_t seed() const;
  void ponderAfter(const PickDecided& decided);
  void ponderAgain(const PickReported& event, const std::vector<int>& available,
                   std::optional<std::size_t> chosen);

  PlannerOptions options_;
  SessionState state_;
  Recorder recorder_;
  std::unique_ptr<Ponderer> ponderer_;  ///< null: not wanted
  double budget_ms_ = 0.0;              ///< of the last decision
};

}  // namespace mixed_palletizing::planning
