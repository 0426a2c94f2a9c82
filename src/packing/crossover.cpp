#include "crossover.hpp"

namespace mixed_palletizing::packing {

Genes crossover(const Genes& a, const Genes& b, std::size_t first, std::size_t last) {
  const std::size_t n = a.size();
  Genes child(n, -1);
  std::vector<bool> taken(n, false);
  for (std::size_t i = first; i < last; ++i) {
    child[i] = a[i];
    taken[static_cast<std::size_t>(a[i])] = true;
  }
  std::size_t to = last % n;
  for (std::size_t k = 0; k < n; ++k) {
    const int gene = b[(last + k) % n];
    if (taken[static_cast<std::size_t>(gene)]) continue;
    child[to] = gene;
    to = (to + 1) % n;
  }
  return child;
}

}  // namespace mixed_palletizing::packing
