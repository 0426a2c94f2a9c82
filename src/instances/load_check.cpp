// Loads on the boxes of a finished pallet, worked out from the top down and apart from the packing core. A load only
// grows while a pallet is loaded, so that its end tells all.
#include <algorithm>
#include <numeric>

#include "placement_check.hpp"

namespace mixed_palletizing::instances {
namespace {

using packing::Placement;

constexpr double kTolerance = 1e-6;  ///< [kg]

double contactArea(const Placement& above, const Placement& below) {
  if (below.origin.z + below.size.z != above.origin.z) return 0.0;
  const int x = std::min(above.origin.x + above.size.x, below.origin.x + below.size.x) -
                std::max(above.origin.x, below.origin.x);
  const int y = std::min(above.origin.y + above.size.y, below.origin.y + below.size.y) -
                std::max(above.origin.y, below.origin.y);
  return x > 0 && y > 0 ? static_cast<double>(x) * y : 0.0;
}

/// What rests on every box [kg].
std::vector<double> loadsOf(const packing::Order& order, const std::vector<Placement>& placements) {
  std::vector<std::size_t> from_top(placements.size());
  std::iota(from_top.begin(), from_top.end(), std::size_t{0});
  std::stable_sort(from_top.begin(), from_top.end(), [&](std::size_t a, std::size_t b) {
    return placements[a].origin.z > placements[b].origin.z;
  });
  std::vector<double> loads(placements.size(), 0.0);
  for (const std::size_t i : from_top) {
    std::vector<double> areas;
    for (const Placement& below : placements) areas.push_back(contactArea(placements[i], below));
    const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
    const double weight = order.types[static_cast<std::size_t>(placements[i].type)].weight_kg + loads[i];
    for (std::size_t k = 0; k < areas.size() && sum > 0.0; ++k) loads[k] += weight * areas[k] / sum;
  }
  return loads;
}

}  // namespace

bool limitsLoads(const packing::Order& order) {
  return std::any_of(order.types.begin(), order.types.end(),
                     [](const packing::ItemType& type) { return type.max_load_kg > 0.0; });
}

std::vector<std::string> loadFaults(const packing::Order& order, const std::vector<Placement>& placements) {
  std::vector<std::string> found;
  double weight = 0.0;
  for (const Placement& p : placements) {
    if (p.type < 0 || static_cast<std::size_t>(p.type) >= order.types.size()) return {};  // has its own fault
    weight += order.types[static_cast<std::size_t>(p.type)].weight_kg;
  }
  if (order.rules.max_weight_kg > 0.0 && weight > order.rules.max_weight_kg + kTolerance) {
    found.push_back("the boxes weigh " + std::to_string(weight) + " kg, at most " +
                    std::to_string(order.rules.max_weight_kg) + " are allowed");
  }
  if (!limitsLoads(order)) return found;
  const std::vector<double> loads = loadsOf(order, placements);
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const double limit = order.types[static_cast<std::size_t>(placements[i].type)].max_load_kg;
    if (limit <= 0.0 || loads[i] <= limit + kTolerance) continue;
    found.push_back("placement " + std::to_string(i) + ": carries " + std::to_string(loads[i]) +
                    " kg, at most " + std::to_string(limit) + " are allowed");
  }
  return found;
}

}  // namespace mixed_palletizing::instances
