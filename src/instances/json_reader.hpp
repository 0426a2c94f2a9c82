// Strict reading of JSON objects: every fault is gathered, keys nobody read are faults.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::instances {

using Json = nlohmann::json;

constexpr int kMaxJsonDepth = 8;
constexpr int kMaxJsonValues = 20000000;  ///< keys and ends of lists and objects count too

/// Parses one JSON text of at most kMaxJsonDepth levels and kMaxJsonValues in which no object has a key twice. Throws
/// std::invalid_argument.
Json parseStrictJson(const std::string& text);

/// A view of one object; faults are appended to `faults` as "where.key: what".
class JsonReader {
 public:
  JsonReader(const Json& value, std::string where, std::vector<std::string>& faults);

  bool has(const std::string& key) const;
  std::string text(const std::string& key);
  int integer(const std::string& key, int min, int max);
  std::uint64_t unsignedInteger(const std::string& key);
  double number(const std::string& key, double min, double max);
  packing::Vec3 lengths(const std::string& key, int min);
  std::vector<int> integers(const std::string& key, int min, int max);
  std::vector<std::string> texts(const std::string& key);
  /// The elements of an array, and the place of each ("where.key[3]").
  std::vector<std::pair<const Json*, std::string>> elements(const std::string& key);
  /// The value as it is; null (and a fault) when the key is missing.
  const Json* value(const std::string& key);

  void fault(const std::string& key, const std::string& what);

  /// Names every key that was not asked for.
  void finish();

 private:
  const Json* array(const std::string& key);

  const Json& value_;
  std::string where_;
  std::vector<std::string>& faults_;
  std::set<std::string> known_;
};

/// Throws std::invalid_argument with all faults when there are any.
void throwFaults(const std::vector<std::string>& faults);

}  // namespace mixed_palletizing::instances
