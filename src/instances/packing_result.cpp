#include <cmath>

#include <mixed_palletizing/instances/packing_result.hpp>

#include "arrival_check.hpp"
#include "placement_check.hpp"

namespace mixed_palletizing::instances {
namespace {

/// Every item of the instance once, among the placements or the unpacked.
std::vector<std::string> itemFaults(const Instance& instance, const PackingResult& result) {
  const std::vector<int> types = itemTypes(instance);
  std::vector<std::string> found;
  std::vector<int> seen(types.size(), 0);
  const auto count = [&](int item, const std::string& where) {
    if (item < 0 || static_cast<std::size_t>(item) >= types.size()) {
      found.push_back(where + ": item " + std::to_string(item) + " does not exist, there are " +
                      std::to_string(types.size()));
      return false;
    }
    if (++seen[static_cast<std::size_t>(item)] == 2) {
      found.push_back(where + ": item " + std::to_string(item) + " occurs twice");
    }
    return true;
  };
  for (std::size_t i = 0; i < result.placements.size(); ++i) {
    const ResultPlacement& placement = result.placements[i];
    const std::string where = "placement " + std::to_string(i);
    if (!count(placement.item, where)) continue;
    if (placement.placement.type != types[static_cast<std::size_t>(placement.item)]) {
      found.push_back(where + ": item " + std::to_string(placement.item) + " is of another type");
    }
  }
  for (const int item : result.unpacked) count(item, "unpacked");
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] == 0) found.push_back("item " + std::to_string(i) + " is neither packed nor unpacked");
  }
  return found;
}

std::vector<std::string> numberFaults(const Instance& instance, const PackingResult& result) {
  std::vector<std::string> found;
  double packed = 0.0;
  for (const ResultPlacement& placement : result.placements) {
    packed += static_cast<double>(packing::volume(placement.placement.size));
  }
  const double utilization = packed / static_cast<double>(packing::volume(instance.order.rules.size));
  if (!(std::abs(result.utilization - utilization) <= kUtilizationTolerance)) {
    found.push_back("utilization " + std::to_string(result.utilization) + " is stated, " +
                    std::to_string(utilization) + " is packed");
  }
  const DecisionTimes& times = result.decision_ms;
  if (!(times.median_ms >= 0.0 && times.median_ms <= times.p99_ms && times.p99_ms <= times.max_ms &&
        std::isfinite(times.max_ms))) {
    found.emplace_back("decision_ms: 0 <= median <= p99 <= max must hold");
  }
  return found;
}

}  // namespace

std::vector<std::string> checkResult(const Instance& instance, const PackingResult& result) {
  std::vector<std::string> found;
  if (result.name != instance.name) {
    found.push_back("name '" + result.name + "' is not that of the instance, '" + instance.name + "'");
  }
  const auto append = [&found](const std::vector<std::string>& more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  append(itemFaults(instance, result));
  std::vector<packing::Placement> placements;
  std::size_t with_available = 0;
  for (const ResultPlacement& placement : result.placements) {
    placements.push_back(placement.placement);
    if (!placement.available.empty()) ++with_available;
  }
  append(placementFaults(instance.order, placements));
  append(numberFaults(instance, result));
  if (with_available == 0) return found;
  if (with_available < result.placements.size()) {
    found.emplace_back("available: is stated for some placements only");
  } else if (found.empty()) {
    append(arrivalFaults(instance, result));
  }
  return found;
}

}  // namespace mixed_palletizing::instances
