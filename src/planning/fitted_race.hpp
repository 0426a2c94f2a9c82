// The race between pairs, run again with a policy fitted to the order when the futures leave much over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <mixed_palletizing/planning/next_pick.hpp>
#include <mixed_palletizing/planning/playout.hpp>

#include "order_policy.hpp"
#include "playout_race.hpp"
#include "sampled_futures.hpp"
#include "scored_placements.hpp"

namespace mixed_palletizing::planning {

class FittedRace {
 public:
  /// A policy, the pairs as it rates them, best first, and how they raced.
  struct Heat {
    PolicyWeights weights{};
    std::vector<ScoredPlacement> pairs;
    std::optional<PlayoutRace> race;  ///< none without pairs
  };

  /// `types`: of the available items that fit, sorted and distinct. What is referred to must outlive this.
  FittedRace(const Situation& situation, const std::vector<int>& types, const PlannerOptions& options,
             std::uint64_t seed, const packing::StopCallback& stop);

  /// With a number of samples one race of so many; without one until `stop` cuts in or nothing is open any more:
  /// where hardly any future becomes perfect, the policy is fitted, and the race run again with what it came to.
  void run(std::optional<int> samples);

  const Heat& result() const { return *heat_; }
  const PlacementPolicy& policy() { return engines_.front().policy(); }

 private:
  std::unique_ptr<Heat> heatWith(const PolicyWeights& weights);
  void runHeat(Heat& heat, std::optional<int> samples);
  bool hardlyPerfect() const;
  void fit();
  void lookAround(Heat& heat, std::size_t plays);
  void adopt(const PolicyWeights& weights, std::size_t plays);

  const Situation& situation_;
  const std::vector<int>& types_;
  const PlannerOptions& options_;
  std::uint64_t seed_;
  const packing::StopCallback& stop_;
  SampledFutures futures_;
  std::vector<Playout> engines_;
  std::unique_ptr<Heat> heat_;
};

}  // namespace mixed_palletizing::planning
