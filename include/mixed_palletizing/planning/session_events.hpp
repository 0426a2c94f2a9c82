// The events of a pallet session.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/knowledge.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>

namespace mixed_palletizing::planning {

enum class PickOutcome { kPlaced, kDiscarded, kFailed };

/// "PLACED", "DISCARDED", "FAILED".
const char* toString(PickOutcome outcome);

enum class ChooseStatus { kPick, kNoneFits, kOrderComplete, kNoPallet, kBadRequest, kConflict };

struct ChooseReply {
  ChooseStatus status = ChooseStatus::kPick;
  std::string message;
  std::uint64_t decision_id = 0;  ///< of kPick and kNoneFits, unique in the life of the session
  Decision decision;
  std::string assumed;    ///< what was taken for granted of the items to come
  bool pondered = false;  ///< thought of before it was asked
};

struct PalletStarted {
  std::string pallet_id;
  packing::Order order;
  OrderKnowledge knowledge = {};
};

/// What the caller of a decision wants to find again: the session only keeps it.
struct CallerNotes {
  std::vector<std::size_t> request_index;          ///< of the available items: where they are in the request
  std::vector<std::array<double, 3>> box_sizes_m;  ///< as detected; empty when they were given by type
};

struct PickDecided {
  std::string request_id;
  std::vector<int> available;
  CallerNotes notes;
  ChooseReply reply;
  double decision_ms = 0.0;
};

struct PickReported {
  std::uint64_t decision_id = 0;
  PickOutcome outcome = PickOutcome::kPlaced;
  std::optional<packing::Placement> measured;  ///< as reported
  std::vector<std::size_t> discarded;          ///< as reported: indices in the decision's available list
};

struct LastUndone {};
struct PalletClosed {};

using SessionEvent = std::variant<PalletStarted, PickDecided, PickReported, LastUndone, PalletClosed>;

}  // namespace mixed_palletizing::planning
