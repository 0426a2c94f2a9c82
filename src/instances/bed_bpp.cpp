// Orders of the BED-BPP benchmark (Kagerer, Beinhofer, Stricker and Nuechter 2023): one JSON object, for each order
//   "id": {"item_sequence": {"1": {"article": .., "length/mm": .., "width/mm": .., "height/mm": ..,
//                                  "weight/kg": .., "sequence": ..}, ..},
//          "properties": {"target": "euro-pallet" or "rollcontainer", ..}}
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>

#include <mixed_palletizing/instances/published_orders.hpp>

#include "json_reader.hpp"

namespace mixed_palletizing::instances {
namespace {

constexpr std::size_t kMaxFileBytes = 512U << 20U;
constexpr double kMaxWeight = 1e6;  ///< [kg]

/// The targets' sizes in the benchmark's own environment [mm].
const std::map<std::string, packing::Vec3> kTargets{{"euro-pallet", {1200, 800, 2000}},
                                                    {"rollcontainer", {800, 700, 2000}}};

std::string wholeText(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text;
  std::array<char, 1U << 16U> part{};
  while (in && text.size() <= kMaxFileBytes) {
    in.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (text.empty()) throw std::runtime_error(path + ": cannot be read or is empty");
  if (text.size() > kMaxFileBytes) {
    throw std::runtime_error(path + ": has more than " + std::to_string(kMaxFileBytes) + " bytes");
  }
  return text;
}

int lineOf(const std::string& text, const std::string& key) {
  const std::size_t at = text.find('"' + key + '"');
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(at == std::string::npos ? 0 : at);
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

/// A length, rounded up to whole millimetres.
int lengthOf(JsonReader& reader, const std::string& key) {
  const double value = reader.number(key, 0.0, packing::kMaxPalletLength);
  if (reader.has(key) && value <= 0.0) reader.fault(key, "must be positive");
  return static_cast<int>(std::ceil(value));
}

class OrderReader {
 public:
  OrderReader(const std::string& name, std::vector<std::string>& faults) : faults_(faults) {
    instance_.name = name;
  }

  Instance read(const Json& value) {
    JsonReader reader(value, "", faults_);
    if (const Json* properties = reader.value("properties")) readTarget(*properties);
    if (const Json* sequence = reader.value("item_sequence")) readSequence(*sequence);
    if (faults_.empty()) faults_ = problems(instance_);
    return instance_;
  }

 private:
  void readTarget(const Json& properties) {
    JsonReader reader(properties, "properties", faults_);
    const std::string target = reader.text("target");
    const auto known = kTargets.find(target);
    if (known != kTargets.end()) {
      instance_.order.rules.size = known->second;
    } else if (reader.has("target")) {
      reader.fault("target", "'" + target + "' is not known");
    }
  }

  void readSequence(const Json& sequence) {
    std::map<long, const Json*> items;
    if (!sequence.is_object()) {
      faults_.emplace_back("item_sequence: an object is needed");
      return;
    }
    for (auto it = sequence.begin(); it != sequence.end(); ++it) {
      char* end = nullptr;
      const long number = std::strtol(it.key().c_str(), &end, 10);
      if (it.key().empty() || *end != '\0' || !items.emplace(number, &it.value()).second) {
        faults_.push_back("item_sequence: key '" + it.key() + "' is no number of its own");
      }
    }
    for (const auto& [number, item] : items) readItem(*item, "item_sequence." + std::to_string(number));
  }

  void readItem(const Json& value, const std::string& where) {
    JsonReader reader(value, where, faults_);
    packing::ItemType type;
    type.name = reader.text("article");
    type.size = {lengthOf(reader, "length/mm"), lengthOf(reader, "width/mm"), lengthOf(reader, "height/mm")};
    if (reader.has("weight/kg")) type.weight_kg = reader.number("weight/kg", 0.0, kMaxWeight);
    type.rotations = packing::Rotations::yawOnly();
    packing::Order& order = instance_.order;
    const auto [found, is_new] = type_of_.emplace(type.name, order.types.size());
    if (is_new) {
      order.types.push_back(type);
      order.counts.push_back(0);
    } else if (order.types[found->second].size != type.size) {
      reader.fault("article", "'" + type.name + "' has other sizes than before");
    }
    ++order.counts[found->second];
    instance_.arrival.push_back(static_cast<int>(found->second));
  }

  std::vector<std::string>& faults_;
  Instance instance_;
  std::map<std::string, std::size_t> type_of_;
};

}  // namespace

InstanceFile readBedBppFile(const std::string& path) {
  const std::string text = wholeText(path);
  InstanceFile file;
  Json orders;
  try {
    orders = parseStrictJson(text);
  } catch (const std::invalid_argument& error) {
    file.faults.push_back(path + ": " + error.what());
    return file;
  }
  if (!orders.is_object() || orders.empty()) {
    file.faults.push_back(path + ":1: an object of orders is needed");
    return file;
  }
  for (auto it = orders.begin(); it != orders.end(); ++it) {
    std::vector<std::string> faults;
    Instance instance = OrderReader(it.key(), faults).read(it.value());
    if (faults.empty()) file.instances.push_back(std::move(instance));
    const std::string where =
        path + ":" + std::to_string(lineOf(text, it.key())) + ": order " + it.key() + ": ";
    for (const std::string& fault : faults) file.faults.push_back(where + fault);
  }
  return file;
}

std::optional<OrderFormat> orderFormatFromString(const std::string& word) {
  if (word == "jsonl") return OrderFormat::kJsonLines;
  if (word == "br") return OrderFormat::kBr;
  if (word == "csv") return OrderFormat::kCsv;
  if (word == "bed_bpp") return OrderFormat::kBedBpp;
  return std::nullopt;
}

InstanceFile readOrders(const std::string& path, OrderFormat format, const CsvRules& csv) {
  switch (format) {
    case OrderFormat::kBr:
      return readBrFile(path);
    case OrderFormat::kCsv:
      return readOrderCsv(path, csv);
    case OrderFormat::kBedBpp:
      return readBedBppFile(path);
    case OrderFormat::kJsonLines:
      break;
  }
  return readInstanceFile(path);
}

}  // namespace mixed_palletizing::instances
