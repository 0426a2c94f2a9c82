// Tunes the weights of the policy on sample orders.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/placement_policy.hpp>

namespace mixed_palletizing::planning {

/// One order to play.
struct TuningOrder {
  packing::Order order;
  std::vector<int> arrival;  ///< types of all its items
  int n_pick = 3;
};

/// The orders of one iteration; asked for once in each, so that the weights do not fit a few orders only.
using TuningOrders = std::function<std::vector<TuningOrder>(int iteration)>;

struct TuningOptions {
  int iterations = 30;
  int population = 48;        ///< vectors of weights tried in an iteration
  double elite_ratio = 0.17;  ///< share of them that the next iteration is drawn around
  double spread = 1.0;        ///< standard deviation of the weights at the start
  int threads = 1;
  std::uint64_t seed = 1;
  PolicyWeights start{};
};

std::vector<std::string> problems(const TuningOptions& options);

/// What the policy alone, without any search, makes of orders.
struct PolicyScore {
  double value = 0.0;  ///< mean of 1 for a perfect pallet less 4 times the volume left over in pallets
  double perfect_ratio = 0.0;  ///< share of the orders
  double unpacked = 0.0;       ///< items per order
};

PolicyScore playPolicy(const std::vector<TuningOrder>& orders, const PolicyWeights& weights);

struct TuningReport {
  int iteration = 0;
  PolicyScore mean;         ///< of the mean weights the iteration began with
  double best_value = 0.0;  ///< of the best vector tried
};

/// Cross-entropy method: the weights are drawn from a normal distribution, independent of each other, whose
/// means and deviations follow the best of each iteration. The same options and orders give the same weights.
/// Throws std::invalid_argument with every line of problems(options).
PolicyWeights tunePolicy(const TuningOptions& options, const TuningOrders& orders,
                         const std::function<void(const TuningReport&)>& report = {});

}  // namespace mixed_palletizing::planning
