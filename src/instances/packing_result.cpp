#include <algorithm>
#include <cmath>
#include <map>

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
  const double room = static_cast<double>(packing::volume(instance.order.rules.size)) * result.pallets;
  const double utilization = packed / room;
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

/// The placements, pallet by pallet.
std::vector<std::string> palletFaults(const Instance& instance, const PackingResult& result) {
  if (result.pallets < 1) return {"pallets: " + std::to_string(result.pallets) + ": must be at least 1"};
  std::vector<std::string> found;
  std::map<int, std::vector<packing::Placement>> pallets;
  for (std::size_t i = 0; i < result.placements.size(); ++i) {
    const int pallet = result.placements[i].pallet;
    if (pallet < 0 || pallet >= result.pallets) {
      found.push_back("placement " + std::to_string(i) + ": pallet " + std::to_string(pallet) + " of " +
                      std::to_string(result.pallets));
    }
    pallets[pallet].push_back(result.placements[i].placement);
  }
  for (const auto& [pallet, placements] : pallets) {
    const std::string name = result.pallets > 1 ? "pallet " + std::to_string(pallet) + ": " : std::string();
    for (const std::string& fault : placementFaults(instance.order, placements)) {
      found.push_back(name + fault);
    }
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
  append(palletFaults(instance, result));
  append(numberFaults(instance, result));
  const auto with_available =
      std::count_if(result.placements.begin(), result.placements.end(),
                    [](const ResultPlacement& placement) { return !placement.available.empty(); });
  if (with_available == 0) return found;
  if (result.pallets > 1) {
    found.emplace_back("available: an arrival is played on one pallet only");
  } else if (static_cast<std::size_t>(with_available) < result.placements.size()) {
    found.emplace_back("available: is stated for some placements only");
  } else if (found.empty()) {
    append(arrivalFaults(instance, result));
  }
  return found;
}

}  // namespace mixed_palletizing::instances
