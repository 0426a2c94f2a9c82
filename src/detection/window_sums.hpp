// Sums of neighbours, one for every place of a line.
#pragma once

#include <cstddef>
#include <vector>

namespace mixed_palletizing::detection {

/// Sums of five neighbours, the first of which is the place itself; added up forwards.
inline void sumForwards(const std::vector<float>& values, std::vector<float>& sums) {
  const float* __restrict__ x = values.data();
  float* __restrict__ sum = sums.data();
  const std::size_t count = values.size() - 4;
  for (std::size_t i = 0; i < count; ++i) sum[i] = x[i] + x[i + 1] + x[i + 2] + x[i + 3] + x[i + 4];
}

/// The same added up backwards: of mirrored values exactly the mirrored sums.
inline void sumBackwards(const std::vector<float>& values, std::vector<float>& sums) {
  const float* __restrict__ x = values.data();
  float* __restrict__ sum = sums.data();
  const std::size_t count = values.size() - 4;
  for (std::size_t i = 0; i < count; ++i) sum[i] = x[i + 4] + x[i + 3] + x[i + 2] + x[i + 1] + x[i];
}

}  // namespace mixed_palletizing::detection
