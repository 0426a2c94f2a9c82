#include "instance_json.hpp"

#include <stdexcept>

#include <mixed_palletizing/instances/files.hpp>

namespace mixed_palletizing::instances {
namespace {

constexpr double kMaxWeight = 1e6;  ///< [kg]

packing::Rotations rotationsFromJson(JsonReader& reader) {
  const Json* value = reader.value("rotations");
  if (value == nullptr) return {};
  if (*value == "none") return packing::Rotations::none();
  if (*value == "yaw") return packing::Rotations::yawOnly();
  if (*value == "any") return packing::Rotations::any();
  packing::Rotations rotations{true, {false, false, false}};
  if (value->is_array() && value->size() == 3 && (*value)[0].is_boolean() && (*value)[1].is_boolean() &&
      (*value)[2].is_boolean()) {
    for (std::size_t i = 0; i < 3; ++i) rotations.vertical[i] = (*value)[i].get<bool>();
    return rotations;
  }
  reader.fault("rotations", R"("none", "yaw", "any" or three booleans are needed)");
  return {};
}

Json rotationsToJson(const packing::ItemType& type) {
  const packing::Rotations& rotations = type.rotations;
  const std::array<bool, 3> upright{false, false, true};
  if (!rotations.yaw && rotations.vertical == upright) return "none";
  if (!rotations.yaw) {
    throw std::invalid_argument("formatInstance: type '" + type.name +
                                "': sides that may stand vertical without a turn about the vertical have no "
                                "word in the format");
  }
  if (rotations.vertical == upright) return "yaw";
  if (rotations.vertical == std::array<bool, 3>{true, true, true}) return "any";
  return rotations.vertical;
}

void itemFromJson(const Json& value, const std::string& where, packing::Order& order,
                  std::vector<std::string>& faults) {
  JsonReader reader(value, where, faults);
  packing::ItemType type;
  type.name = reader.text("type");
  type.size = reader.lengths("size_mm", 1);
  if (reader.has("rotations")) type.rotations = rotationsFromJson(reader);
  if (reader.has("weight_kg")) type.weight_kg = reader.number("weight_kg", 0.0, kMaxWeight);
  if (reader.has("max_load_kg")) {
    type.max_load_kg = reader.number("max_load_kg", 0.0, kMaxWeight);
    if (type.max_load_kg == 0.0) reader.fault("max_load_kg", "must be positive; leave it out for no limit");
  }
  order.counts.push_back(reader.integer("count", 1, packing::kMaxItems));
  order.types.push_back(type);
  reader.finish();
}

packing::Placement placementFromJson(const Json& value, const std::string& where, const packing::Order& order,
                                     std::vector<std::string>& faults) {
  JsonReader reader(value, where, faults);
  packing::Placement placement;
  const std::string name = reader.text("type");
  placement.type = typeIndex(order, name);
  if (placement.type < 0) reader.fault("type", "'" + name + "' is no type of the items");
  placement.origin = reader.lengths("origin_mm", -packing::kMaxPalletLength);
  placement.size = reader.lengths("size_mm", 1);
  reader.finish();
  return placement;
}

}  // namespace

Json toJson(const packing::Vec3& v) { return Json::array({v.x, v.y, v.z}); }

int typeIndex(const packing::Order& order, const std::string& name) {
  for (std::size_t i = 0; i < order.types.size(); ++i) {
    if (order.types[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

Instance instanceFromJson(const Json& line, std::vector<std::string>& faults) {
  const std::size_t faults_before = faults.size();
  JsonReader reader(line, "", faults);
  Instance instance;
  packing::Order& order = instance.order;
  instance.name = reader.text("name");
  order.rules.size = reader.lengths("pallet_mm", 1);
  for (const auto& [item, where] : reader.elements("items")) itemFromJson(*item, where, order, faults);
  if (reader.has("n_pick")) instance.n_pick = reader.integer("n_pick", 1, packing::kMaxItems);
  if (reader.has("gap_mm")) order.rules.gap = reader.integer("gap_mm", 0, packing::kMaxPalletLength);
  if (reader.has("min_support_ratio")) {
    order.rules.min_support_ratio = reader.number("min_support_ratio", 0.0, 1.0);
  }
  if (reader.has("overhang_mm")) {
    order.rules.overhang = reader.integer("overhang_mm", 0, packing::kMaxPalletLength);
  }
  if (reader.has("max_weight_kg"))
    order.rules.max_weight_kg = reader.number("max_weight_kg", 0.0, kMaxWeight);
  if (reader.has("arrival")) {
    for (const auto& [element, where] : reader.elements("arrival")) {
      const std::string name = element->is_string() ? element->get<std::string>() : std::string();
      instance.arrival.push_back(typeIndex(order, name));
      if (instance.arrival.back() < 0) faults.push_back(where + ": '" + name + "' is no type of the items");
    }
    if (instance.arrival.empty()) reader.fault("arrival", "is empty; leave it out when it is not known");
  }
  if (reader.has("perfect_packing")) {
    for (const auto& [element, where] : reader.elements("perfect_packing")) {
      instance.perfect_packing.push_back(placementFromJson(*element, where, order, faults));
    }
    if (instance.perfect_packing.empty()) reader.fault("perfect_packing", "is empty; leave it out");
  }
  reader.finish();
  if (faults.size() == faults_before) {
    for (const std::string& problem : problems(instance)) faults.push_back(problem);
  }
  return instance;
}

Instance parseInstance(const std::string& line) {
  std::vector<std::string> faults;
  Instance instance = instanceFromJson(parseStrictJson(line), faults);
  throwFaults(faults);
  return instance;
}

std::string formatInstance(const Instance& instance) {
  const packing::Order& order = instance.order;
  Json line;
  line["name"] = instance.name;
  line["pallet_mm"] = toJson(order.rules.size);
  line["items"] = Json::array();
  for (std::size_t i = 0; i < order.types.size(); ++i) {
    const packing::ItemType& type = order.types[i];
    Json item{{"type", type.name},
              {"size_mm", toJson(type.size)},
              {"count", order.counts.at(i)},
              {"rotations", rotationsToJson(type)}};
    if (type.weight_kg != 0.0) item["weight_kg"] = type.weight_kg;
    if (type.max_load_kg != 0.0) item["max_load_kg"] = type.max_load_kg;
    line["items"].push_back(item);
  }
  line["n_pick"] = instance.n_pick;
  line["gap_mm"] = order.rules.gap;
  line["min_support_ratio"] = order.rules.min_support_ratio;
  if (order.rules.overhang > 0) line["overhang_mm"] = order.rules.overhang;
  if (order.rules.max_weight_kg > 0.0) line["max_weight_kg"] = order.rules.max_weight_kg;
  const auto name = [&order](int type) { return order.types.at(static_cast<std::size_t>(type)).name; };
  for (const int type : instance.arrival) line["arrival"].push_back(name(type));
  for (const packing::Placement& p : instance.perfect_packing) {
    line["perfect_packing"].push_back(
        {{"type", name(p.type)}, {"origin_mm", toJson(p.origin)}, {"size_mm", toJson(p.size)}});
  }
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mixed_palletizing::instances
