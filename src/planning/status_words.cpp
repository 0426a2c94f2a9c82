#include <mixed_palletizing/planning/pallet_session.hpp>

namespace mixed_palletizing::planning {

const char* toString(SessionStatus status) {
  switch (status) {
    case SessionStatus::kOk:
      return "OK";
    case SessionStatus::kNoPallet:
      return "NO_PALLET";
    case SessionStatus::kPalletOpen:
      return "PALLET_OPEN";
    case SessionStatus::kBadRequest:
      return "BAD_REQUEST";
    case SessionStatus::kUnknownDecision:
      return "UNKNOWN_DECISION";
    case SessionStatus::kConflict:
      return "CONFLICT";
    case SessionStatus::kNothingToUndo:
      return "NOTHING_TO_UNDO";
  }
  return "UNKNOWN";
}

const char* toString(PickOutcome outcome) {
  switch (outcome) {
    case PickOutcome::kPlaced:
      return "PLACED";
    case PickOutcome::kDiscarded:
      return "DISCARDED";
    case PickOutcome::kFailed:
      return "FAILED";
  }
  return "UNKNOWN";
}

const char* toString(ChooseStatus status) {
  switch (status) {
    case ChooseStatus::kPick:
      return "PICK";
    case ChooseStatus::kNoneFits:
      return "NONE_FITS";
    case ChooseStatus::kOrderComplete:
      return "ORDER_COMPLETE";
    case ChooseStatus::kNoPallet:
      return "NO_PALLET";
    case ChooseStatus::kBadRequest:
      return "BAD_REQUEST";
    case ChooseStatus::kConflict:
      return "CONFLICT";
  }
  return "UNKNOWN";
}

}  // namespace mixed_palletizing::planning
