#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/instances/files.hpp>

#include "instance_json.hpp"

namespace mixed_palletizing::instances {
namespace {

constexpr double kMaxTime = 1e12;  ///< [ms]

DecisionTimes timesFromJson(const Json& value, std::vector<std::string>& faults) {
  JsonReader reader(value, "decision_ms", faults);
  DecisionTimes times;
  times.median_ms = reader.number("median", 0.0, kMaxTime);
  times.p99_ms = reader.number("p99", 0.0, kMaxTime);
  times.max_ms = reader.number("max", 0.0, kMaxTime);
  reader.finish();
  return times;
}

/// More than 1 where boxes may stick out of the pallet.
double maxUtilization(const Instance& instance) {
  const packing::PalletRules& rules = instance.order.rules;
  return static_cast<double>(packing::volume(rules.room().size())) /
         static_cast<double>(packing::volume(rules.size));
}

}  // namespace

PackingResult resultFromJson(const Json& line, const Instance& instance, std::vector<std::string>& faults) {
  JsonReader reader(line, "", faults);
  PackingResult result;
  result.name = reader.text("name");
  for (const auto& [value, where] : reader.elements("placements")) {
    JsonReader entry(*value, where, faults);
    ResultPlacement placement;
    placement.item = entry.integer("item", 0, INT32_MAX);
    const std::string type = entry.text("type");
    placement.placement.type = typeIndex(instance.order, type);
    if (placement.placement.type < 0) entry.fault("type", "'" + type + "' is no type of the instance");
    placement.placement.origin = entry.lengths("origin_mm", INT32_MIN);
    placement.placement.size = entry.lengths("size_mm", INT32_MIN);
    if (entry.has("available")) placement.available = entry.integers("available", 0, INT32_MAX);
    if (entry.has("pallet")) placement.pallet = entry.integer("pallet", 0, packing::kMaxItems);
    entry.finish();
    result.placements.push_back(std::move(placement));
  }
  result.unpacked = reader.integers("unpacked", 0, INT32_MAX);
  if (reader.has("pallets")) result.pallets = reader.integer("pallets", 1, packing::kMaxItems);
  result.utilization = reader.number("utilization", 0.0, maxUtilization(instance) + kUtilizationTolerance);
  if (const Json* times = reader.has("decision_ms") ? reader.value("decision_ms") : nullptr) {
    result.decision_ms = timesFromJson(*times, faults);
  }
  if (reader.has("method")) result.method = reader.text("method");
  if (reader.has("seed")) result.seed = reader.unsignedInteger("seed");
  reader.finish();
  return result;
}

PackingResult parseResult(const std::string& line, const Instance& instance) {
  std::vector<std::string> faults;
  PackingResult result = resultFromJson(parseStrictJson(line), instance, faults);
  throwFaults(faults);
  return result;
}

std::string formatResult(const PackingResult& result, const Instance& instance) {
  const DecisionTimes& times = result.decision_ms;
  for (const double number : {result.utilization, times.median_ms, times.p99_ms, times.max_ms}) {
    if (!std::isfinite(number)) {
      throw std::invalid_argument("formatResult: result: utilization and times must be finite");
    }
  }
  Json line;
  line["name"] = result.name;
  line["placements"] = Json::array();
  for (const ResultPlacement& placement : result.placements) {
    const auto type = static_cast<std::size_t>(placement.placement.type);
    Json entry{{"item", placement.item},
               {"type", instance.order.types.at(type).name},
               {"origin_mm", toJson(placement.placement.origin)},
               {"size_mm", toJson(placement.placement.size)}};
    if (!placement.available.empty()) entry["available"] = placement.available;
    if (result.pallets > 1) entry["pallet"] = placement.pallet;
    line["placements"].push_back(std::move(entry));
  }
  line["unpacked"] = result.unpacked;
  if (result.pallets > 1) line["pallets"] = result.pallets;
  line["utilization"] = result.utilization;
  line["decision_ms"] = {{"median", times.median_ms}, {"p99", times.p99_ms}, {"max", times.max_ms}};
  line["method"] = result.method;
  line["seed"] = result.seed;
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mixed_palletizing::instances
