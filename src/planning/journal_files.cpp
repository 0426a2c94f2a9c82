// Layout: `events`, one row each, and one row `head` with the first and the last sequence number and the last
// checksum, changed in the same transactions. SQLite itself finds broken pages (integrity_check), the checksums
// find changed contents, the head finds rows that are missing at either end.
#include "journal_files.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <mixed_palletizing/planning/journal_error.hpp>

namespace mixed_palletizing::planning {
namespace {

constexpr std::int64_t kApplicationId = 0x4d50504a;  // "MPPJ"
constexpr std::int64_t kVersion = 1;

std::int64_t pragma(const SqliteDatabase& database, const std::string& name) {
  SqliteStatement statement(database, "PRAGMA " + name);
  return statement.step() ? statement.integer(0) : 0;
}

/// FNV-1a, 64 bits (Fowler, Noll and Vo): every step is a bijection of the state, so that one changed byte
/// cannot leave the end unchanged.
class Hash {
 public:
  void add(const std::string& text) {
    for (const char c : text) {
      state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    }
    state_ = (state_ ^ 0x1fU) * 0x100000001b3ULL;  // ends a field
  }

  std::string hex() const {
    constexpr std::array<char, 17> kDigits{"0123456789abcdef"};
    std::string text;
    for (unsigned shift = 64; shift > 0; shift -= 4) text += kDigits[(state_ >> (shift - 4U)) & 0xfU];
    return text;
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

std::string integrityFault(const SqliteDatabase& database) {
  SqliteStatement check(database, "PRAGMA integrity_check(1)");
  const std::string answer = check.step() ? check.text(0) : "no answer";
  return answer == "ok" ? "" : answer;
}

JournalRow rowOf(const SqliteStatement& s) {
  return {s.integer(0), s.integer(1), s.integer(2), s.integer(3), s.text(4), s.text(5), s.text(6), s.text(7)};
}

/// What is wrong with the rows; empty when nothing is.
std::string faultOf(const std::vector<JournalRow>& rows, std::int64_t first, std::int64_t last,
                    const std::string& chain) {
  std::string before;
  std::int64_t expected = first;
  std::int64_t pallet = 0;
  for (const JournalRow& row : rows) {
    if (row.sequence != expected++) return "event " + std::to_string(expected - 1) + " is missing";
    if (row.pallet != pallet) before.clear();
    pallet = row.pallet;
    before = chainAfter(before, row);
    if (before != row.chain) return "event " + std::to_string(row.sequence) + " was changed";
  }
  if (expected != last + 1) return "event " + std::to_string(last) + " is missing";
  if (!rows.empty() && rows.back().chain != chain) return "the last event does not match";
  return "";
}

}  // namespace

std::string chainAfter(const std::string& before, const JournalRow& row) {
  Hash hash;
  hash.add(before);
  for (const std::int64_t number : {row.sequence, row.pallet, row.revision, row.next_decision}) {
    hash.add(std::to_string(number));
  }
  for (const std::string* text : {&row.time, &row.kind, &row.body}) hash.add(*text);
  return hash.hex();
}

void throwDamaged(const std::string& path, const std::string& what) {
  throw JournalError(
      path + ": the journal is damaged (" + what +
      "), so that what stands on the pallet cannot be told from it: bring back a copy of it, or "
      "move it and the files named after it away to begin with an empty pallet");
}

void throwFaultOf(const std::string& path, const SqliteError& error) {
  switch (error.code()) {
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_NOMEM:
      throw JournalError(
          path + ": the journal cannot be used (" + error.what() +
          "): see that its disk is sound and not full and that this user may write there, then "
          "start the planner again");
    default:
      throwDamaged(path, error.what());
  }
}

void makePrivateFile(const std::string& path) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::absolute(path).parent_path();
  if (fs::create_directories(folder)) fs::permissions(folder, fs::perms::owner_all);
  // Private from its first moment, whatever the umask; SQLite gives the files beside it the same rights.
  const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file >= 0) {
    ::close(file);
  } else if (errno == EEXIST) {
    std::error_code not_ours;  // a copy that was brought back
    fs::permissions(path, fs::perms::group_all | fs::perms::others_all, fs::perm_options::remove, not_ours);
  } else {
    throw JournalError(path + ": cannot be made: " + std::strerror(errno));
  }
}

JournalLock::JournalLock(const std::string& journal_path) : path_(journal_path + ".lock") {
  makePrivateFile(path_);
  try {
    database_ = std::make_unique<SqliteDatabase>(path_, false);
    take();
    database_->execute("CREATE TABLE IF NOT EXISTS made (id INTEGER PRIMARY KEY)");
  } catch (const SqliteError& error) {
    if (error.code() == SQLITE_BUSY) {
      throw JournalError(journal_path +
                         ": another planner has this journal open: end it, or give this one a "
                         "journal of its own");
    }
    throwFaultOf(path_, error);
  }
}

void JournalLock::take() { database_->execute("BEGIN EXCLUSIVE"); }

bool JournalLock::journalWasMade() const { return SqliteStatement(*database_, "SELECT id FROM made").step(); }

void JournalLock::setJournalMade() {
  database_->execute("INSERT OR IGNORE INTO made VALUES (1); COMMIT");
  take();
}

void makeTables(const SqliteDatabase& database) {
  database.execute(
      "BEGIN IMMEDIATE;"
      "CREATE TABLE events (sequence INTEGER PRIMARY KEY, pallet INTEGER NOT NULL, revision INTEGER NOT NULL,"
      " next_decision INTEGER NOT NULL, time TEXT NOT NULL, kind TEXT NOT NULL, body TEXT NOT NULL,"
      " chain TEXT NOT NULL);"
      "CREATE TABLE head (id INTEGER PRIMARY KEY CHECK (id = 1), first INTEGER NOT NULL, last INTEGER NOT "
      "NULL,"
      " chain TEXT NOT NULL);"
      "INSERT INTO head VALUES (1, 1, 0, '');"
      "PRAGMA application_id = " +
      std::to_string(kApplicationId) + "; PRAGMA user_version = " + std::to_string(kVersion) + "; COMMIT");
}

std::vector<JournalRow> readRows(const SqliteDatabase& database, const std::string& path) {
  std::vector<JournalRow> rows;
  try {
    if (pragma(database, "application_id") != kApplicationId)
      throwDamaged(path, "it is no journal of a planner");
    const std::int64_t version = pragma(database, "user_version");
    if (version != kVersion) throwDamaged(path, "version " + std::to_string(version) + " is not known");
    const std::string broken = integrityFault(database);
    if (!broken.empty()) throwDamaged(path, broken);
    SqliteStatement head(database, "SELECT first, last, chain FROM head");
    if (!head.step()) throwDamaged(path, "its head is missing");
    SqliteStatement select(database,
                           "SELECT sequence, pallet, revision, next_decision, time, kind, body, chain "
                           "FROM events ORDER BY sequence");
    while (select.step()) rows.push_back(rowOf(select));
    const std::string fault = faultOf(rows, head.integer(0), head.integer(1), head.text(2));
    if (!fault.empty()) throwDamaged(path, fault);
  } catch (const SqliteError& error) {
    throwFaultOf(path, error);
  }
  return rows;
}

}  // namespace mixed_palletizing::planning
