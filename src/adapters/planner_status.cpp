#include "planner_status.hpp"

#include <mixed_palletizing/ChooseNextPick.h>
#include <mixed_palletizing/ReportPick.h>
#include <mixed_palletizing/StartPallet.h>
#include <mixed_palletizing/UndoLast.h>

namespace mixed_palletizing::adapters {

using planning::ChooseStatus;
using planning::SessionStatus;

std::uint8_t codeOf(SessionStatus status) {
  switch (status) {
    case SessionStatus::kOk:
      return StartPalletResponse::OK;
    case SessionStatus::kNoPallet:
      return ReportPickResponse::NO_PALLET;
    case SessionStatus::kPalletOpen:
      return StartPalletResponse::PALLET_OPEN;
    case SessionStatus::kBadRequest:
      return StartPalletResponse::BAD_REQUEST;
    case SessionStatus::kUnknownDecision:
      return ReportPickResponse::UNKNOWN_DECISION;
    case SessionStatus::kConflict:
      return ReportPickResponse::CONFLICT;
    case SessionStatus::kNothingToUndo:
      return UndoLastResponse::NOTHING_TO_UNDO;
  }
  return StartPalletResponse::FAILED;
}

std::uint8_t codeOf(ChooseStatus status) {
  switch (status) {
    case ChooseStatus::kPick:
      return ChooseNextPickResponse::PICK;
    case ChooseStatus::kNoneFits:
      return ChooseNextPickResponse::NONE_FITS;
    case ChooseStatus::kOrderComplete:
      return ChooseNextPickResponse::ORDER_COMPLETE;
    case ChooseStatus::kNoPallet:
      return ChooseNextPickResponse::NO_PALLET;
    case ChooseStatus::kBadRequest:
      return ChooseNextPickResponse::BAD_REQUEST;
    case ChooseStatus::kConflict:
      return ChooseNextPickResponse::CONFLICT;
  }
  return ChooseNextPickResponse::FAILED;
}

}  // namespace mixed_palletizing::adapters
