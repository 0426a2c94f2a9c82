// The session of one pallet: what is ordered, placed, discarded and decided.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>
#include <mixed_palletizing/planning/session_state.hpp>

namespace mixed_palletizing::planning {

enum class SessionStatus {
  kOk,
  kNoPallet,
  kPalletOpen,
  kBadRequest,
  kUnknownDecision,  ///< never made, or stale: something was reported or taken back since
  kConflict,         ///< the same id with another content
  kNothingToUndo,
};

struct SessionReply {
  SessionStatus status = SessionStatus::kOk;
  std::string message;
  bool ok() const { return status == SessionStatus::kOk; }
};

struct PalletSummary {
  std::string pallet_id;
  int placed = 0;
  int discarded = 0;
  int remaining = 0;  ///< neither placed nor discarded when the pallet was closed
  double utilization = 0.0;
  std::array<double, 3> center_of_gravity_mm{};  ///< by volume where weights are not known
  int decisions = 0;
  double median_decision_ms = 0.0;
  double p99_decision_ms = 0.0;
  double max_decision_ms = 0.0;
  double unpacked_volume_ratio = 0.0;  ///< of the items discarded or never come, in volumes of the pallet
  double min_support_ratio = 1.0;      ///< the least supported base of all boxes; 1 when none was placed
  double gravity_margin_mm =
      0.0;  ///< centre of gravity to the nearest edge of the floor area the boxes cover
};

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

  /// kPalletOpen while another pallet is open, unless `close_open`; kBadRequest with every line of
  /// problems(order), or for an empty id.
  SessionReply start(const std::string& pallet_id, const packing::Order& order, bool close_open);

  /// Decides which of `available` (type indices) to pick next. The same request_id with the same items gets
  /// the same answer until something is reported or taken back; an empty id is never remembered. Changes
  /// neither the pallet nor the order. `elapsed_ms_of_caller` [ms] is added to the decision's time in the
  /// summary; `notes` are kept with the decision.
  ChooseReply choose(const std::string& request_id, const std::vector<int>& available,
                     const packing::StopCallback& stop, double elapsed_ms_of_caller = 0.0,
                     const CallerNotes& notes = {});

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
  std::vector<int> remaining() const;          ///< count per type
  std::vector<int> discarded() const;          ///< count per type
  std::uint64_t revision() const;              ///< grows with every change
  const PickDecided* pendingDecision() const;  ///< the last one, not yet reported; null when there is none
  std::optional<KnownDecision> knownDecision(std::uint64_t decision_id) const;  ///< open or reported
  PalletSummary summary() const;  ///< so far; empty when no pallet is open

 private:
  void record(const std::vector<SessionEvent>& events);

  PlannerOptions options_;
  SessionState state_;
  Recorder recorder_;
};

/// The word of interfaces for a status: "PICK", "NONE_FITS", "OK", "NO_PALLET", ...
const char* toString(SessionStatus status);
const char* toString(ChooseStatus status);

}  // namespace mixed_palletizing::planning
