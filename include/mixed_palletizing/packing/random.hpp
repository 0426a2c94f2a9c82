// Random draws that are the same with every standard library.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace mixed_palletizing::packing {

using Random = std::mt19937_64;

/// Uniform in [0, 1).
inline double uniform01(Random& random) { return static_cast<double>(random() >> 11) * 0x1.0p-53; }

/// Uniform in 0 .. count - 1; count > 0.
inline std::size_t uniformIndex(Random& random, std::size_t count) {
  return static_cast<std::size_t>(uniform01(random) * static_cast<double>(count));
}

/// Standard normal by Box and Muller: the same with every standard library.
inline double normal(Random& random) {
  constexpr double kTwoPi = 6.283185307179586;
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform01(random)));
  return radius * std::cos(kTwoPi * uniform01(random));
}

template <typename T>
void shuffle(std::vector<T>& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[uniformIndex(random, i)]);
}

}  // namespace mixed_palletizing::packing
