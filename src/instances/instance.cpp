#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

#include <mixed_palletizing/instances/instance.hpp>

#include "placement_check.hpp"

namespace mixed_palletizing::instances {
namespace {

std::vector<int> countsOf(const std::vector<int>& item_types, std::size_t type_count) {
  std::vector<int> counts(type_count, 0);
  for (const int type : item_types) {
    if (type >= 0 && static_cast<std::size_t>(type) < type_count) ++counts[static_cast<std::size_t>(type)];
  }
  return counts;
}

/// One line when the items are not exactly those of the order.
void compareWithOrder(const char* what, const std::vector<int>& item_types, const packing::Order& order,
                      std::vector<std::string>& found) {
  for (const int type : item_types) {
    if (type < 0 || static_cast<std::size_t>(type) >= order.types.size()) {
      found.push_back(std::string(what) + ": " + std::to_string(type) + ": is no type of the order");
      return;
    }
  }
  const std::vector<int> counts = countsOf(item_types, order.types.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == order.counts[i]) continue;
    found.push_back(std::string(what) + ": " + std::to_string(counts[i]) + " of type '" +
                    order.types[i].name + "': the order has " + std::to_string(order.counts[i]));
  }
}

}  // namespace

std::vector<std::string> problems(const Instance& instance) {
  std::vector<std::string> found = packing::problems(instance.order);
  if (instance.name.empty()) found.emplace_back("name: '': must not be empty");
  if (instance.n_pick < 1) {
    found.push_back("n_pick: " + std::to_string(instance.n_pick) + ": must be at least 1");
  }
  if (!found.empty()) return found;
  if (!instance.arrival.empty()) compareWithOrder("arrival", instance.arrival, instance.order, found);
  if (!instance.perfect_packing.empty()) {
    std::vector<int> item_types;
    for (const packing::Placement& placement : instance.perfect_packing) item_types.push_back(placement.type);
    const std::size_t before = found.size();
    compareWithOrder("perfect_packing", item_types, instance.order, found);
    if (found.size() == before) {
      for (const std::string& fault : placementFaults(instance.order, instance.perfect_packing)) {
        found.push_back("perfect_packing: " + fault);
      }
    }
  }
  return found;
}

std::vector<int> expandedItems(const packing::Order& order) {
  std::vector<int> items;
  for (std::size_t i = 0; i < order.counts.size(); ++i) {
    items.insert(items.end(), static_cast<std::size_t>(std::max(order.counts[i], 0)), static_cast<int>(i));
  }
  return items;
}

std::vector<int> itemTypes(const Instance& instance) {
  return instance.arrival.empty() ? expandedItems(instance.order) : instance.arrival;
}

std::vector<int> arrivalItems(const Instance& instance, std::uint64_t seed) {
  std::vector<int> items(itemTypes(instance).size());
  std::iota(items.begin(), items.end(), 0);
  if (instance.arrival.empty()) {
    std::mt19937_64 rng(seed);
    std::shuffle(items.begin(), items.end(), rng);
  }
  return items;
}

std::vector<int> arrivalOf(const Instance& instance, std::uint64_t seed) {
  const std::vector<int> types = itemTypes(instance);
  std::vector<int> arrival;
  for (const int item : arrivalItems(instance, seed))
    arrival.push_back(types[static_cast<std::size_t>(item)]);
  return arrival;
}

}  // namespace mixed_palletizing::instances
