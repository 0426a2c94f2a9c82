// What a session answers.
#pragma once

#include <string>

#include <mixed_palletizing/planning/session_events.hpp>

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

/// The word of interfaces for a status: "PICK", "NONE_FITS", "OK", "NO_PALLET", ...
const char* toString(SessionStatus status);
const char* toString(ChooseStatus status);

}  // namespace mixed_palletizing::planning
