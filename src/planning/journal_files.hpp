// The tables of a journal and the lock beside it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sqlite_database.hpp"

namespace mixed_palletizing::planning {

/// An event row as it is stored; `chain` is the checksum over this row and the one before of its pallet.
struct JournalRow {
  std::int64_t sequence = 0;
  std::int64_t pallet = 0;
  std::int64_t revision = 0;
  std::int64_t next_decision = 0;
  std::string time;
  std::string kind;
  std::string body;
  std::string chain;
};

/// The checksum that belongs to a row after one with `before`; "" before the first row of a pallet. A change of
/// any single byte of a row changes it.
std::string chainAfter(const std::string& before, const JournalRow& row);

/// Throws JournalError "PATH: the journal is damaged (WHAT): ..." with what to do.
[[noreturn]] void throwDamaged(const std::string& path, const std::string& what);

/// Throws JournalError with what to do: throwDamaged() when the database is not sound, otherwise "PATH: the journal
/// cannot be used (WHAT): ..." as it is with a full, broken or read-only disk.
[[noreturn]] void throwFaultOf(const std::string& path, const SqliteError& error);

/// Makes the folder and an empty file that only the user can read, unless they are there.
void makePrivateFile(const std::string& path);

/// Keeps every other planner out while it lives, and remembers that a journal was made.
class JournalLock {
 public:
  /// Throws JournalError when another one holds it.
  explicit JournalLock(const std::string& journal_path);
  bool journalWasMade() const;
  void setJournalMade();

 private:
  void take();
  std::string path_;
  std::unique_ptr<SqliteDatabase> database_;
};

void makeTables(const SqliteDatabase& database);

/// All rows in their order, each checked against its neighbours and the head. Throws JournalError.
std::vector<JournalRow> readRows(const SqliteDatabase& database, const std::string& path);

}  // namespace mixed_palletizing::planning
