// Random numbers by hashing a counter: no state, so the order of evaluation and the threads never matter.
#pragma once

#include <cmath>
#include <cstdint>

namespace mixed_palletizing::simulation {

/// Finalizer of SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
inline std::uint64_t mixBits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// The independent random numbers of one seed: one for every (index, stream).
class CounterRandom {
 public:
  explicit CounterRandom(std::uint64_t seed) : key_(mixBits(seed)) {}

  std::uint64_t bits(std::uint64_t index, std::uint32_t stream) const {
    return mixBits(mixBits(key_ + index) ^ (static_cast<std::uint64_t>(stream) << 32));
  }

  /// Uniform in (0, 1), never 0 or 1.
  double uniform(std::uint64_t index, std::uint32_t stream) const {
    return (static_cast<double>(bits(index, stream) >> 12) + 0.5) * 0x1p-52;
  }

  /// Standard normal by Box and Muller; uses `stream` and `stream + 1`.
  double gaussian(std::uint64_t index, std::uint32_t stream) const {
    const double radius = std::sqrt(-2.0 * std::log(uniform(index, stream)));
    constexpr double kTwoPi = 6.283185307179586;
    return radius * std::cos(kTwoPi * uniform(index, stream + 1));
  }

 private:
  std::uint64_t key_;
};

}  // namespace mixed_palletizing::simulation
