#include "json_reader.hpp"

#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/instances/files.hpp>

namespace mixed_palletizing::instances {
namespace {

constexpr std::size_t kMaxQuote = 40;

std::string quote(const Json& value) {
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= kMaxQuote ? text : text.substr(0, kMaxQuote) + "...";
}

bool toInteger(const Json& value, int min, int max, int& result) {
  if (!value.is_number_integer()) return false;
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(INT32_MAX))
    return false;
  const auto number = value.get<std::int64_t>();
  if (number < min || number > max) return false;
  result = static_cast<int>(number);
  return true;
}

std::string range(int min, int max) {
  return max == INT32_MAX ? "of at least " + std::to_string(min)
                          : "from " + std::to_string(min) + " to " + std::to_string(max);
}

}  // namespace

Json parseStrictJson(const std::string& text) {
  std::vector<std::set<std::string>> keys;
  int values = 0;
  const auto watch = [&keys, &values](int depth, Json::parse_event_t event, Json& value) {
    if (depth >= kMaxJsonDepth) {
      throw std::invalid_argument("more than " + std::to_string(kMaxJsonDepth) + " levels of JSON");
    }
    if (++values > kMaxJsonValues) {
      throw std::invalid_argument("more than " + std::to_string(kMaxJsonValues) + " values of JSON");
    }
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end && !keys.empty()) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second) {
      throw std::invalid_argument("key " + quote(value) + " occurs twice in one object");
    }
    return true;
  };
  try {
    return Json::parse(text, watch);
  } catch (const nlohmann::json::exception& error) {
    std::string what = error.what();
    const std::size_t tag = what.find("] ");  // "[json.exception.parse_error.101] parse error at ..."
    throw std::invalid_argument("no JSON: " + (tag == std::string::npos ? what : what.substr(tag + 2)));
  }
}

JsonReader::JsonReader(const Json& value, std::string where, std::vector<std::string>& faults)
    : value_(value), where_(std::move(where)), faults_(faults) {
  if (!value_.is_object()) {
    faults_.push_back((where_.empty() ? "line" : where_) + ": an object is needed, not " + quote(value_));
  }
}

bool JsonReader::has(const std::string& key) const { return value_.is_object() && value_.contains(key); }

void JsonReader::fault(const std::string& key, const std::string& what) {
  faults_.push_back((where_.empty() ? key : where_ + "." + key) + ": " + what);
}

const Json* JsonReader::value(const std::string& key) {
  known_.insert(key);
  if (has(key)) return &value_.at(key);
  if (value_.is_object()) fault(key, "is missing");
  return nullptr;
}

std::string JsonReader::text(const std::string& key) {
  const Json* found = value(key);
  if (found == nullptr) return {};
  if (found->is_string()) return found->get<std::string>();
  fault(key, "a string is needed, not " + quote(*found));
  return {};
}

int JsonReader::integer(const std::string& key, int min, int max) {
  const Json* found = value(key);
  int result = min;
  if (found != nullptr && !toInteger(*found, min, max, result)) {
    fault(key, "an integer " + range(min, max) + " is needed, not " + quote(*found));
  }
  return result;
}

std::uint64_t JsonReader::unsignedInteger(const std::string& key) {
  const Json* found = value(key);
  if (found == nullptr) return 0;
  if (found->is_number_unsigned()) return found->get<std::uint64_t>();
  fault(key, "a non-negative integer is needed, not " + quote(*found));
  return 0;
}

double JsonReader::number(const std::string& key, double min, double max) {
  const Json* found = value(key);
  if (found == nullptr) return min;
  const double result = found->is_number() ? found->get<double>() : std::nan("");
  if (result >= min && result <= max) return result;
  fault(key,
        "a number from " + Json(min).dump() + " to " + Json(max).dump() + " is needed, not " + quote(*found));
  return min;
}

packing::Vec3 JsonReader::lengths(const std::string& key, int min) {
  const Json* found = value(key);
  if (found == nullptr) return {};
  packing::Vec3 result;
  if (found->is_array() && found->size() == 3 && toInteger((*found)[0], min, INT32_MAX, result.x) &&
      toInteger((*found)[1], min, INT32_MAX, result.y) && toInteger((*found)[2], min, INT32_MAX, result.z)) {
    return result;
  }
  fault(key, "three integers of at least " + std::to_string(min) + " [mm] are needed, not " + quote(*found));
  return {};
}

const Json* JsonReader::array(const std::string& key) {
  const Json* found = value(key);
  if (found == nullptr || found->is_array()) return found;
  fault(key, "an array is needed, not " + quote(*found));
  return nullptr;
}

std::vector<int> JsonReader::integers(const std::string& key, int min, int max) {
  std::vector<int> result;
  for (const auto& [element, place] : elements(key)) {
    int number = 0;
    if (toInteger(*element, min, max, number)) {
      result.push_back(number);
    } else {
      faults_.push_back(place + ": an integer " + range(min, max) + " is needed, not " + quote(*element));
    }
  }
  return result;
}

std::vector<std::string> JsonReader::texts(const std::string& key) {
  std::vector<std::string> result;
  for (const auto& [element, place] : elements(key)) {
    if (element->is_string()) {
      result.push_back(element->get<std::string>());
    } else {
      faults_.push_back(place + ": a string is needed, not " + quote(*element));
    }
  }
  return result;
}

std::vector<std::pair<const Json*, std::string>> JsonReader::elements(const std::string& key) {
  std::vector<std::pair<const Json*, std::string>> result;
  const Json* found = array(key);
  if (found == nullptr) return result;
  for (std::size_t i = 0; i < found->size(); ++i) {
    result.emplace_back(&(*found)[i],
                        (where_.empty() ? key : where_ + "." + key) + "[" + std::to_string(i) + "]");
  }
  return result;
}

void JsonReader::finish() {
  if (!value_.is_object()) return;
  for (auto it = value_.begin(); it != value_.end(); ++it) {
    if (known_.count(it.key()) == 0) fault(it.key(), "is no known key");
  }
}

void throwFaults(const std::vector<std::string>& faults) {
  if (!faults.empty()) throw std::invalid_argument(joinFaults(faults));
}

}  // namespace mixed_palletizing::instances
