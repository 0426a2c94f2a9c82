// Random numbers in sequence.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <mixed_palletizing/simulation/recipe.hpp>

#include "counter_random.hpp"

namespace mixed_palletizing::simulation {

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}

  double between(double low, double high) { return low + (high - low) * random_.uniform(count_++, 0); }
  double in(const Range& range) { return between(range.min, range.max); }
  int in(const CountRange& range) {
    const double number = std::floor(between(range.min, static_cast<double>(range.max) + 1.0));
    return std::min(static_cast<int>(number), range.max);
  }
  bool chance(double ratio) { return between(0.0, 1.0) < ratio; }

  /// One of a list that is not empty.
  template <typename T>
  const T& one(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(in(CountRange{0, static_cast<int>(list.size()) - 1}))];
  }

 private:
  CounterRandom random_;
  std::uint64_t count_ = 0;
};

}  // namespace mixed_palletizing::simulation
