// The distribution of the cross-entropy method over the weights of a policy.
#pragma once

#include <cstdint>
#include <vector>

#include <mixed_palletizing/packing/random.hpp>
#include <mixed_palletizing/planning/placement_policy.hpp>

namespace mixed_palletizing::planning {

/// A vector of weights and what it was found to be worth.
struct TriedWeights {
  PolicyWeights weights{};
  double value = 0.0;
};

/// Normal, the weights independent of each other.
class CrossEntropy {
 public:
  /// `noise` is added to every deviation at first and fades.
  CrossEntropy(const PolicyWeights& mean, double spread, double noise, std::uint64_t seed);

  /// The mean and `count` - 1 drawn ones.
  std::vector<PolicyWeights> draw(std::size_t count);

  /// Lets mean and deviations follow the best; equal ones in the order given.
  void follow(std::vector<TriedWeights> tried, std::size_t elite);

  const PolicyWeights& mean() const { return mean_; }

 private:
  PolicyWeights mean_;
  PolicyWeights deviation_{};
  double noise_;
  int generation_ = 0;
  packing::Random random_;
};

}  // namespace mixed_palletizing::planning
