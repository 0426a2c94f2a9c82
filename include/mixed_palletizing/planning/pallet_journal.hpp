// The journal of a planner: every event of its session, durable, so that a killed planner goes on where it was.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <mixed_palletizing/planning/journal_error.hpp>
#include <mixed_palletizing/planning/session_state.hpp>

namespace mixed_palletizing::planning {

/// One event as the journal holds it.
struct JournalEntry {
  std::int64_t sequence = 0;           ///< counts all events of the journal
  std::int64_t pallet = 0;             ///< counts the pallets
  std::uint64_t revision = 0;          ///< of the session before the event
  std::uint64_t next_decision_id = 1;  ///< before the event
  std::string time;                    ///< UTC, ISO 8601
  SessionEvent event;
};

/// A SQLite database (WAL, synchronous=FULL) that only its user can read, beside it PATH.lock, by which a
/// second planner is kept out, and while it is open SQLite's own PATH-wal and PATH-shm.
///
/// Each event carries a checksum over itself and the one before, and a last row counts them: what was changed,
/// cut off or half written by anybody but the journal is found when it is opened.
class PalletJournal {
 public:
  /// Opens the journal, or makes one with its folder. The events of the last `keep_pallets` pallets are kept.
  /// Throws JournalError when another planner has it open, when it is damaged, or when it cannot be written.
  PalletJournal(const std::string& path, int keep_pallets);
  ~PalletJournal();

  /// What the session was after its last event.
  SessionState restore() const;

  /// Durable, all or none, when it returns. `before` is the state they are applied to. Throws JournalError.
  void append(const SessionState& before, const std::vector<SessionEvent>& events);

 private:
  class Files;
  std::unique_ptr<Files> files_;
  SessionState restored_;
  int keep_pallets_;
};

/// All entries of a journal, also while a planner has it open. Throws JournalError.
std::vector<JournalEntry> readJournal(const std::string& path);

/// The state after `entries`, which are of one pallet and begin with its start. Throws std::invalid_argument
/// when they do not follow from each other.
SessionState replay(const std::vector<JournalEntry>& entries);

}  // namespace mixed_palletizing::planning
