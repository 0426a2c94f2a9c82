// Random orders with a known perfect packing (thesis 4.2.1).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/instances/instance.hpp>

namespace mixed_palletizing::instances {

/// Defaults: the thesis' EUR pallet with footprints of 1/4, 1/8 and 1/16 and heights of 300, 200 and 100 mm.
struct GeneratorOptions {
  packing::Vec3 pallet{1200, 800, 600};
  std::vector<int> footprint_divisors{4, 8, 16};  ///< powers of two: 4 = a quarter of the pallet's area
  std::vector<int> heights{300, 200, 100};        ///< [mm]
  int n_pick = 3;
};

std::vector<std::string> problems(const GeneratorOptions& options);

/// One order whose items fill the pallet without waste, with that packing and a shuffled arrival. The same
/// options, seed and index give the same instance. Throws std::invalid_argument with every line of
/// problems(options).
Instance generateInstance(const GeneratorOptions& options, std::uint64_t seed, int index);

}  // namespace mixed_palletizing::instances
