#include "standing_check.hpp"

#include <mixed_palletizing/instances/files.hpp>
#include <mixed_palletizing/instances/packing_result.hpp>

namespace mixed_palletizing::torture {

std::string unsound(const packing::Order& order, const std::vector<packing::Placement>& placements) {
  instances::Instance instance;
  instance.name = "p";
  instance.order = order;
  instances::PackingResult result;
  result.name = instance.name;
  std::vector<int> next(order.types.size(), 0);
  for (std::size_t t = 1; t < next.size(); ++t) next[t] = next[t - 1] + order.counts[t - 1];
  const std::vector<int> first = next;
  double volume = 0.0;
  for (const packing::Placement& placement : placements) {
    result.placements.push_back({next[static_cast<std::size_t>(placement.type)]++, placement, {}});
    volume += static_cast<double>(packing::volume(placement.size));
  }
  for (std::size_t t = 0; t < next.size(); ++t) {
    for (int item = next[t]; item < first[t] + order.counts[t]; ++item) result.unpacked.push_back(item);
  }
  result.utilization = volume / static_cast<double>(packing::volume(order.rules.size));
  return instances::joinFaults(instances::checkResult(instance, result));
}

}  // namespace mixed_palletizing::torture
