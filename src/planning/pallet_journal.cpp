// An event is acknowledged when it is in the database file itself: after every commit the write-ahead log is
// copied into it and emptied (wal_checkpoint). A log that is cut off or changed can then lose nothing that was
// ever acknowledged, and the database file is protected by its checksums.
#include <filesystem>
#include <utility>

#include <mixed_palletizing/planning/pallet_journal.hpp>

#include "event_json.hpp"
#include "journal_files.hpp"

namespace mixed_palletizing::planning {
namespace {

JournalEntry entryOf(const JournalRow& row) {
  JournalEntry entry;
  entry.sequence = row.sequence;
  entry.pallet = row.pallet;
  entry.revision = static_cast<std::uint64_t>(row.revision);
  entry.next_decision_id = static_cast<std::uint64_t>(row.next_decision);
  entry.time = row.time;
  entry.event = eventFromJson(row.kind, parseEvent(row.body));
  return entry;
}

std::string now(const SqliteDatabase& database) {
  SqliteStatement select(database, "SELECT strftime('%Y-%m-%dT%H:%M:%fZ', 'now')");
  return select.step() ? select.text(0) : "";
}

}  // namespace

class PalletJournal::Files {
 public:
  explicit Files(const std::string& path) : path_(path), lock_(path) {
    makePrivateFile(path);
    const bool is_new = std::filesystem::file_size(path) == 0 && !std::filesystem::exists(path + "-wal");
    if (is_new && lock_.journalWasMade()) throwDamaged(path, "the file is empty");
    try {
      database_ = std::make_unique<SqliteDatabase>(path, false);
      database_->execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
      SqliteStatement tables(*database_, "SELECT count(*) FROM sqlite_master");
      if (tables.step() && tables.integer(0) == 0 && !lock_.journalWasMade()) makeTables(*database_);
    } catch (const SqliteError& error) {
      throwFaultOf(path, error);
    }
    rows_ = readRows(*database_, path);
    lock_.setJournalMade();
  }

  /// The entries of the last pallet; the rows are forgotten.
  std::vector<JournalEntry> takeLastPallet() {
    std::vector<JournalEntry> entries;
    try {
      for (const JournalRow& row : rows_) {
        if (row.pallet == rows_.back().pallet) entries.push_back(entryOf(row));
      }
    } catch (const std::exception& error) {
      throwDamaged(path_, error.what());
    }
    if (!rows_.empty()) last_ = rows_.back();
    last_.body.clear();
    rows_.clear();
    return entries;
  }

  void append(const SessionState& before, const std::vector<SessionEvent>& events, int keep_pallets) {
    SessionState state = before;
    JournalRow last = last_;
    try {
      database_->execute("BEGIN IMMEDIATE");
      for (const SessionEvent& event : events) {
        last = insert(state, event, last);
        state.apply(event);
      }
      SqliteStatement head(*database_, "UPDATE head SET last = ?1, chain = ?2");
      head.bind(1, last.sequence);
      head.bind(2, last.chain);
      head.step();
      if (last.pallet != last_.pallet) forgetBefore(last.pallet - keep_pallets + 1);
      database_->execute("COMMIT");
    } catch (const std::exception& error) {
      // Whatever this answers: the transaction ends here, by SQLite itself if not by this.
      sqlite3_exec(database_->handle(), "ROLLBACK", nullptr, nullptr, nullptr);
      throw JournalError(path_ + ": " + error.what());
    }
    last_ = std::move(last);
    // Durable already; a reader that is busy only puts this off until the next event.
    sqlite3_wal_checkpoint_v2(database_->handle(), nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
  }

  const std::string& path() const { return path_; }

 private:
  JournalRow insert(const SessionState& state, const SessionEvent& event, const JournalRow& last) {
    const bool starts = std::holds_alternative<PalletStarted>(event);
    JournalRow row;
    row.sequence = last.sequence + 1;
    row.pallet = last.pallet + (starts ? 1 : 0);
    row.revision = static_cast<std::int64_t>(state.revision());
    row.next_decision = static_cast<std::int64_t>(state.nextDecisionId());
    row.time = now(*database_);
    row.kind = kindOf(event);
    row.body = toJson(event).dump();
    row.chain = chainAfter(starts ? "" : last.chain, row);
    SqliteStatement statement(*database_, "INSERT INTO events VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)");
    int index = 0;
    for (const std::int64_t number : {row.sequence, row.pallet, row.revision, row.next_decision}) {
      statement.bind(++index, number);
    }
    for (const std::string* text : {&row.time, &row.kind, &row.body, &row.chain})
      statement.bind(++index, *text);
    statement.step();
    row.body.clear();
    return row;
  }

  void forgetBefore(std::int64_t pallet) {
    SqliteStatement forget(*database_, "DELETE FROM events WHERE pallet < ?1");
    forget.bind(1, pallet);
    forget.step();
    database_->execute("UPDATE head SET first = (SELECT min(sequence) FROM events)");
  }

  std::string path_;
  JournalLock lock_;
  std::unique_ptr<SqliteDatabase> database_;
  std::vector<JournalRow> rows_;  ///< only while opening
  JournalRow last_;               ///< without its body
};

PalletJournal::PalletJournal(const std::string& path, int keep_pallets) : keep_pallets_(keep_pallets) {
  if (keep_pallets < 1) {
    throw std::invalid_argument("PalletJournal: keep_pallets: " + std::to_string(keep_pallets) +
                                ": must be at least 1");
  }
  try {
    files_ = std::make_unique<Files>(path);
    restored_ = replay(files_->takeLastPallet());
  } catch (const std::filesystem::filesystem_error& error) {
    throw JournalError(path + ": " + error.code().message());
  } catch (const SqliteError& error) {
    throwFaultOf(path, error);
  } catch (const std::invalid_argument& error) {
    throwDamaged(path, error.what());
  }
}

PalletJournal::~PalletJournal() = default;

SessionState PalletJournal::restore() const { return restored_; }

void PalletJournal::append(const SessionState& before, const std::vector<SessionEvent>& events) {
  files_->append(before, events, keep_pallets_);
}

std::vector<JournalEntry> readJournal(const std::string& path) {
  if (!std::filesystem::exists(path)) throw JournalError(path + ": there is no such file");
  std::vector<JournalEntry> entries;
  try {
    const SqliteDatabase database(path, true);
    database.execute("BEGIN");  // one view of it while a planner writes
    for (const JournalRow& row : readRows(database, path)) entries.push_back(entryOf(row));
  } catch (const SqliteError& error) {
    throwFaultOf(path, error);
  } catch (const nlohmann::json::exception& error) {
    throwDamaged(path, error.what());
  } catch (const std::invalid_argument& error) {
    throwDamaged(path, error.what());
  }
  return entries;
}

SessionState replay(const std::vector<JournalEntry>& entries) {
  if (entries.empty()) return {};
  SessionState state(entries.front().revision, entries.front().next_decision_id);
  for (const JournalEntry& entry : entries) {
    if (entry.revision != state.revision() || entry.next_decision_id != state.nextDecisionId()) {
      throw std::invalid_argument("replay: event " + std::to_string(entry.sequence) + " is of revision " +
                                  std::to_string(entry.revision) + ", not " +
                                  std::to_string(state.revision()));
    }
    state.apply(entry.event);
  }
  return state;
}

}  // namespace mixed_palletizing::planning
