// Sequences in which the rest of an order may come.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <mixed_palletizing/planning/next_pick.hpp>
#include <mixed_palletizing/planning/playout.hpp>

namespace mixed_palletizing::planning {

/// Where the futures of a situation begin: as many items stay visible as are now.
PlayoutStart playoutStart(const Situation& situation);

class SampledFutures {
 public:
  SampledFutures(const Situation& situation, std::uint64_t seed);

  /// What may come after the available items, in a random order: the items known, and of every type with a forecast a
  /// number drawn from the Poisson distribution: the arrivals of a stream in the time that brings so many in the
  /// mean. The same index gives the same sequence again.
  std::vector<int> arrival(std::size_t future) const;

  /// All that is to come is of one type: there is nothing to draw.
  bool onlyOne() const;

 private:
  std::vector<int> to_come_;      ///< known, sorted
  std::vector<double> forecast_;  ///< expected beside them, per type; empty = none
  std::uint64_t seed_;
};

}  // namespace mixed_palletizing::planning
