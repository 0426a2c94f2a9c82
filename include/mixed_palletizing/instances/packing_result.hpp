// Results: the placements of one instance in loading order.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/instances/instance.hpp>
#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::instances {

struct ResultPlacement {
  int item = 0;  ///< index in the arrival (or in the expanded item list when the instance has none)
  packing::Placement placement;
  std::vector<int> available;  ///< indices visible at that moment; empty for order-free packings
  int pallet = 0;              ///< which of the pallets, from 0
};

struct DecisionTimes {
  double median_ms = 0.0;
  double p99_ms = 0.0;
  double max_ms = 0.0;
};

struct PackingResult {
  std::string name;
  std::vector<ResultPlacement> placements;  ///< in loading order, pallet by pallet
  std::vector<int> unpacked;                ///< item indices
  double utilization = 0.0;                 ///< packed volume over that of all pallets
  DecisionTimes decision_ms;
  std::string method;
  std::uint64_t seed = 0;
  int pallets = 1;  ///< used
};

constexpr double kUtilizationTolerance = 1e-6;  ///< between the stated and the packed utilization

/// Independent check of every placement, written without the packing core's spaces: inside, no overlap,
/// support, loadable from above, gap, every item once, the stated number of pallets and utilization, and
/// (when `available` is given, on one pallet) the rules of arrival with n_pick visible, as far as everything else is sound. Every fault as one
/// line; empty when the result is valid. The instance must be sound (problems()).
std::vector<std::string> checkResult(const Instance& instance, const PackingResult& result);

}  // namespace mixed_palletizing::instances
