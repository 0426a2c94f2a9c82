// SQLite with errors as exceptions and statements that end by themselves.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include <sqlite3.h>

namespace mixed_palletizing::planning {

class SqliteError : public std::runtime_error {
 public:
  SqliteError(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
  int code() const { return code_; }  ///< primary result code of SQLite

 private:
  int code_;
};

class SqliteDatabase {
 public:
  /// Throws SqliteError. A database that is opened for writing is made when there is none.
  SqliteDatabase(const std::string& path, bool read_only);

  /// Runs one or several statements without results.
  void execute(const std::string& sql) const;

  sqlite3* handle() const { return handle_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close(handle); }
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

/// One prepared statement. Texts are UTF-8; a bound text is copied.
class SqliteStatement {
 public:
  SqliteStatement(const SqliteDatabase& database, const std::string& sql);

  void bind(int index, std::int64_t value);
  void bind(int index, const std::string& value);

  /// True when there is a row to read.
  bool step();

  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string text(int column) const;

 private:
  void check(int code) const;

  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

}  // namespace mixed_palletizing::planning
