// What a pallet session remembers, changed by events only, so that a journal of the events restores it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/session_events.hpp>

namespace mixed_palletizing::planning {

/// A report, and what is needed to recognize it when it is repeated.
struct ReportedPick {
  PickReported report;
  CallerNotes notes;                          ///< of the decision
  std::optional<packing::Placement> planned;  ///< by the decision
};

/// One open pallet. All of it follows from the events applied since PalletStarted.
struct OpenPallet {
  std::string id;
  packing::Order order;
  OrderKnowledge knowledge;
  packing::PalletState pallet;
  std::vector<int> taken;      ///< count per type, placed or discarded
  std::vector<int> remaining;  ///< count per type of those sure to come: neither placed nor discarded
  std::vector<int> discarded;  ///< count per type
  /// Not yet reported, oldest first, of the present revision only.
  std::deque<std::shared_ptr<const PickDecided>> decisions;
  std::vector<double> decision_ms;  ///< of every decision
  struct Change {                   ///< one that can be taken back
    std::uint64_t decision_id = 0;
    std::vector<int> discarded_types;  ///< empty: a box was placed
  };
  std::vector<Change> changes;

  /// What a decision over these available items (type indices) starts from.
  Situation situation(const std::vector<int>& available) const;
  /// Why these items cannot be available; empty when they can.
  std::string problemOf(const std::vector<int>& available) const;
  /// Items of a type are placed or discarded, or come back when `count` is negative.
  void take(int type, int count);
};

/// The placement a decision chose, if any.
std::optional<packing::Placement> plannedPlacement(const Decision& decision);

class SessionState {
 public:
  SessionState() = default;
  /// With no pallet open, and these numbers to go on with.
  SessionState(std::uint64_t revision, std::uint64_t next_decision_id)
      : next_decision_id_(next_decision_id), revision_(revision) {}

  /// How many decisions of one revision are remembered; the oldest is forgotten first.
  static constexpr std::size_t kMaxDecisions = 16;

  /// Throws std::invalid_argument when the event cannot follow what was applied before; the state is then as
  /// it was.
  void apply(const SessionEvent& event);

  const OpenPallet* open() const { return open_ ? &*open_ : nullptr; }

  /// The remembered decision with this id, null when there is none.
  const PickDecided* decision(std::uint64_t decision_id) const;
  /// The report that was accepted for this decision and not taken back, null when there is none. Kept after
  /// the pallet is closed until the next one starts.
  const ReportedPick* report(std::uint64_t decision_id) const;

  std::uint64_t nextDecisionId() const { return next_decision_id_; }
  std::uint64_t revision() const { return revision_; }

 private:
  void on(const PalletStarted& event);
  void on(const PickDecided& event);
  void on(const PickReported& event);
  void on(const LastUndone& event);
  void on(const PalletClosed& event);

  std::optional<OpenPallet> open_;
  std::map<std::uint64_t, std::shared_ptr<const ReportedPick>> reports_;  ///< shared: copied with every event
  std::uint64_t next_decision_id_ = 1;
  std::uint64_t revision_ = 0;
};

}  // namespace mixed_palletizing::planning
