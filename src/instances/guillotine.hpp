// Fills a pallet with boxes without waste by cutting its volume again and again.
#pragma once

#include <random>
#include <set>
#include <vector>

#include <mixed_palletizing/instances/generator.hpp>

namespace mixed_palletizing::instances {

/// A part of the pallet halved across its longer side; the halves lie side by side in x or in y.
struct Half {
  packing::Vec3 size;
  bool along_x = true;
};

/// Throws std::invalid_argument when the longer side is odd.
Half halve(const packing::Vec3& part);

/// reachable[h]: h [mm] is a sum of the heights, each used any number of times; h = 0 ... total.
std::vector<bool> reachableHeights(const std::vector<int>& heights, int total);

/// options.heights, or every height from the smallest to the largest of them.
std::vector<int> heightsOf(const GeneratorOptions& options);

class GuillotineFiller {
 public:
  struct Box {
    packing::Vec3 origin;
    packing::Vec3 size;
  };

  /// `options` must be sound (problems()).
  GuillotineFiller(const GeneratorOptions& options, std::mt19937_64& rng);

  /// Fills a part of the pallet, whose footprint is 1/divisor of it, with boxes.
  void fill(const packing::Vec3& origin, const packing::Vec3& size, int divisor);

  const std::vector<Box>& boxes() const { return boxes_; }

 private:
  /// Of a horizontal cut through a part, before its footprint is looked at (structure "blocks").
  static constexpr double kCutProbability = 0.5;

  bool chance(double probability);
  int oneOf(const std::vector<int>& choices);
  void fillColumn(packing::Vec3 origin, const packing::Vec3& size);
  std::vector<int> cuts(int total) const;

  const GeneratorOptions& options_;
  const std::vector<int> heights_;
  const std::set<int> divisors_;
  const std::vector<bool> reachable_;
  std::mt19937_64& rng_;
  std::vector<Box> boxes_;
};

/// Boxes that fill the pallet for PackingStructure::kCuts: the largest box that can be cut is cut across one of its
/// sides, the longer the likelier, until there are options.boxes.
std::vector<GuillotineFiller::Box> cutBoxes(const GeneratorOptions& options, std::mt19937_64& rng);

}  // namespace mixed_palletizing::instances
