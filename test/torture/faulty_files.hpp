// A layer below SQLite in which writing fails, or the power goes, at a chosen operation.
#pragma once

#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <sqlite3.h>

namespace mixed_palletizing::torture {

/// Operations counted: write, truncate, sync and remove, of all files. One object at a time; it is SQLite's default
/// layer from its first use to the end of the program.
class FaultyFiles {
 public:
  static FaultyFiles& instance();

  /// From now on nothing fails, and operations are counted from 0.
  void reset();
  /// Operation number `at` answers `write_code`, or `sync_code` if it is a sync; with `forever` all after it too.
  void failAt(int at, int write_code, int sync_code, bool forever);
  /// The power goes at operation number `at`: it and all after it fail. `seed` draws what of the writes since the
  /// last sync of a file reached the disk.
  void cutPowerAt(int at, std::uint64_t seed);

  int operations() const { return count_; }
  bool happened() const { return happened_; }

  /// After the power went: writes the files as the disk holds them; what is only in memory is removed.
  void restoreDisk() const;

 private:
  FaultyFiles();
  friend struct FaultyFileMethods;

  struct Write {
    sqlite3_int64 offset;  ///< -1: a truncation to `size`
    sqlite3_int64 size;
    std::string bytes;
  };
  /// SQLITE_OK or what the operation has to answer.
  int next(bool is_sync);
  void opened(const std::string& path);
  void written(const std::string& path, Write write);
  void synced(const std::string& path);
  void removed(const std::string& path);

  int count_ = 0;
  int fail_at_ = -1;
  int write_code_ = 0;
  int sync_code_ = 0;
  bool forever_ = false;
  bool power_ = false;  ///< what is on the disk is followed
  bool happened_ = false;
  std::mt19937_64 rng_;
  std::map<std::string, std::string> disk_;               ///< what was synced of every file
  std::map<std::string, std::vector<Write>> since_sync_;  ///< what was not
};

}  // namespace mixed_palletizing::torture
