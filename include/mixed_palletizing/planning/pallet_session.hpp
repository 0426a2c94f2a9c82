// The session of one pallet: what is ordered, placed, discarded and decided. Kept in memory.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>

namespace mixed_palletizing::planning {

enum class SessionStatus {
  kOk,
  kNoPallet,
  kPalletOpen,
  kBadRequest,
  kUnknownDecision,
  kConflict,  ///< the same id with another content
  kNothingToUndo,
};

struct SessionReply {
  SessionStatus status = SessionStatus::kOk;
  std::string message;
  bool ok() const { return status == SessionStatus::kOk; }
};

enum class PickOutcome { kPlaced, kDiscarded, kFailed };

struct PalletSummary {
  std::string pallet_id;
  int placed = 0;
  int discarded = 0;
  int remaining = 0;
  double utilization = 0.0;
  std::array<double, 3> center_of_gravity_mm{};  ///< by volume where weights are not known
  double median_decision_ms = 0.0;
  double max_decision_ms = 0.0;
};

enum class ChooseStatus { kPick, kNoneFits, kOrderComplete, kNoPallet, kBadRequest, kConflict };

struct ChooseReply {
  ChooseStatus status = ChooseStatus::kPick;
  std::string message;
  std::uint64_t decision_id = 0;  ///< of kPick and kNoneFits
  Decision decision;
};

/// One pallet from start to close. Every call answers a status and leaves the state unchanged when it
/// refuses. Not thread safe.
class PalletSession {
 public:
  explicit PalletSession(const PlannerOptions& options);

  SessionReply start(const std::string& pallet_id, const packing::Order& order, bool close_open);

  /// The same request_id with the same items gets the same answer until something is reported; an empty id is
  /// never remembered. Changes neither the pallet nor the order.
  ChooseReply choose(const std::string& request_id, const std::vector<int>& available,
                     const packing::StopCallback& stop, double elapsed_ms_of_caller = 0.0);

  /// `placement` overrides the planned one when the robot measured another pose. Repeating a report is
  /// harmless. kDiscarded takes the items at `discarded` (indices in the decision's available list) out of
  /// the order.
  SessionReply report(std::uint64_t decision_id, PickOutcome outcome,
                      const std::optional<packing::Placement>& placement,
                      const std::vector<std::size_t>& discarded);

  SessionReply undoLast();
  SessionReply close(PalletSummary& summary);

  bool open() const;
  const packing::PalletState* pallet() const;  ///< null when no pallet is open
  const packing::Order* order() const;
  const std::string& palletId() const;
  std::vector<int> remaining() const;                          ///< count per type
  std::vector<int> discarded() const;                          ///< count per type
  std::uint64_t revision() const;                              ///< grows with every change
  std::optional<packing::Placement> pendingPlacement() const;  ///< of the last decision, not yet reported
};

}  // namespace mixed_palletizing::planning
