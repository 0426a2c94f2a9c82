// The policy fitted to the order at hand: weights that play the rest of this very order better.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/planning/playout.hpp>

#include "cross_entropy.hpp"
#include "sampled_futures.hpp"

namespace mixed_palletizing::planning {

class OrderPolicy {
 public:
  /// Futures begin at `start`, the search at `weights` with a standard deviation of `spread`. What is referred to must outlive this.
  OrderPolicy(const PlayoutStart& start, const SampledFutures& futures, std::vector<Playout>& engines,
              const PolicyWeights& weights, double spread, std::uint64_t seed);

  /// Searches with at least so many more plays. False when `stop` cut in; the generation under way is lost.
  bool search(std::size_t plays, const packing::StopCallback& stop);

  /// What the search has come to.
  const PolicyWeights& weights() const { return search_.mean(); }

  /// Whether `weights` play futures that the search has not seen clearly better than `others`; false too when `stop`
  /// cut in.
  bool better(const PolicyWeights& weights, const PolicyWeights& others, const packing::StopCallback& stop);

 private:
  bool play(const std::vector<PolicyWeights>& weights, std::size_t first_future, std::size_t count,
            const packing::StopCallback& stop, std::vector<double>& values);

  const PlayoutStart& start_;
  const SampledFutures& futures_;
  std::vector<Playout>& engines_;
  CrossEntropy search_;
  std::size_t next_future_;
  std::size_t futures_of_generation_;
  std::size_t futures_to_compare_;
};

}  // namespace mixed_palletizing::planning
