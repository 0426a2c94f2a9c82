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
  kCuts,     ///< boxes of any size: the volume cut across again and again, at any millimetre
};

/// Parses "columns", "blocks" or "cuts"; std::nullopt for another word.
std::optional<PackingStructure> packingStructureFromString(const std::string& word);

/// Defaults: the thesis' EUR pallet with footprints of 1/4, 1/8 and 1/16 and heights of 300, 200 and 100 mm.
struct GeneratorOptions {
  packing::Vec3 pallet{1200, 800, 600};
  std::vector<int> footprint_divisors{4, 8, 16};  ///< powers of two: 4 = a quarter of the pallet's area
  std::vector<int> heights{300, 200, 100};        ///< [mm]
  bool continuous_heights = false;                ///< any from the smallest to the largest of `heights`
  PackingStructure structure = PackingStructure::kBlocks;

  // Of kCuts, which has no use for divisors and heights.
  int boxes = 40;       ///< to be cut, as far as min_side allows
  int min_side = 100;   ///< of a box [mm]
  double spread = 0.5;  ///< share of a side, about its middle, in which it is cut; 0 = always in the middle

  packing::Rotations rotations;  ///< of all items; boxes that can be turned into each other are one type

  // With any of the next two the perfect packing is no longer one, so the instance has none.
  int size_spread = 0;             ///< every side of every type is drawn anew within so much of its own [mm]
  int gap = 0;                     ///< rule of the pallet [mm]
  double min_support_ratio = 1.0;  ///< rule of the pallet

  int n_pick = 3;
};

std::vector<std::string> problems(const GeneratorOptions& options);

/// The footprint [mm] of a share 1/divisor of the pallet: its longer side is halved again and again, so that
/// the footprints of one pallet tile each other (1200x800: 600x400, 300x400, 300x200, 150x200). z is 0.
/// Throws std::invalid_argument when the divisor is no power of two or a side cannot be halved.
packing::Vec3 footprint(const packing::Vec3& pallet, int divisor);

/// One order whose items fill the pallet without waste, with that packing and a shuffled arrival; about so with a
/// size_spread. The same
/// options, seed and index give the same instance. Throws std::invalid_argument with every line of
/// problems(options).
Instance generateInstance(const GeneratorOptions& options, std::uint64_t seed, int index);

}  // namespace mixed_palletizing::instances
