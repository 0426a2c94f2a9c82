// One instance packed free of order, as a result.
#pragma once

#include <cstdint>
#include <string>

#include <mixed_palletizing/instances/instance.hpp>
#include <mixed_palletizing/instances/packing_result.hpp>
#include <mixed_palletizing/packing/order_packing.hpp>

namespace mixed_palletizing::instances {

struct PackRun {
  packing::PackOptions options;
  std::string method;                ///< word for the result
  double time_limit_s = 10.0;        ///< for one order [s]; 0 = none
  std::int64_t max_evaluations = 0;  ///< of the search, for one order; 0 = no limit
  int max_pallets = 1;               ///< for one order; 0 = as many as it needs
};

/// Every broken rule as one line; empty when the run can start.
std::vector<std::string> problems(const PackRun& run);

/// Packs the items of an instance in the sequence the method finds. Without a time limit the same run gives
/// the same result. Throws std::invalid_argument for broken options.
PackingResult packInstance(const Instance& instance, const PackRun& run);

/// "orders 150  packed completely 150  pallets 420, at least 400 by volume and weight  mean utilization 86.20 %".
class PackSummary {
 public:
  void add(const Instance& instance, const PackingResult& result);
  std::string text() const;

 private:
  int orders_ = 0;
  int complete_ = 0;
  int pallets_ = 0;
  int least_pallets_ = 0;
  double utilization_ = 0.0;
};

}  // namespace mixed_palletizing::instances
