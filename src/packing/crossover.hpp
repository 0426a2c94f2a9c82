// Two-cut crossover of permutations with circular fill (thesis 3.3.2, Fig. 3.19).
#pragma once

#include <cstddef>
#include <vector>

namespace mixed_palletizing::packing {

/// A permutation of item indices.
using Genes = std::vector<int>;

/// Copies the genes of `a` in [first, last); the rest comes from `b`, circularly from the second cut on. Both are
/// permutations of the same indices, first <= last <= size.
Genes crossover(const Genes& a, const Genes& b, std::size_t first, std::size_t last);

}  // namespace mixed_palletizing::packing
