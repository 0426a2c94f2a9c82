// Random orders with a known perfect packing (thesis 4.2.1).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/instances/instance.hpp>

namespace mixed_palletizing::instances {

/// How the boxes of the known packing stand.
enum class PackingStructure {
  kColumns,  ///< columns of one footprint each, from the floor to the top
  kBlocks,   ///< boxes also stand across several columns of smaller ones
};

/// Parses "columns" or "blocks"; std::nullopt for another word.
std::optional<PackingStructure> packingStructureFromString(const std::string& word);

/// Defaults: the thesis' EUR pallet with footprints of 1/4, 1/8 and 1/16 and heights of 300, 200 and 100 mm.
struct GeneratorOptions {
  packing::Vec3 pallet{1200, 800, 600};
  std::vector<int> footprint_divisors{4, 8, 16};  ///< powers of two: 4 = a quarter of the pallet's area
  std::vector<int> heights{300, 200, 100};        ///< [mm]
  PackingStructure structure = PackingStructure::kBlocks;
  int n_pick = 3;
};

std::vector<std::string> problems(const GeneratorOptions& options);

/// The footprint [mm] of a share 1/divisor of the pallet: its longer side is halved again and again, so that
/// the footprints of one pallet tile each other (1200x800: 600x400, 300x400, 300x200, 150x200). z is 0.
/// Throws std::invalid_argument when the divisor is no power of two or a side cannot be halved.
packing::Vec3 footprint(const packing::Vec3& pallet, int divisor);

/// One order whose items fill the pallet without waste, with that packing and a shuffled arrival. The same
/// options, seed and index give the same instance. Throws std::invalid_argument with every line of
/// problems(options).
Instance generateInstance(const GeneratorOptions& options, std::uint64_t seed, int index);

}  // namespace mixed_palletizing::instances
