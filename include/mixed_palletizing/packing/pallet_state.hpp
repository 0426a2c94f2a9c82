// The boxes on a pallet and the empty supported maximal spaces (ESMS) around them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

/// Value type: copy it to try something; a copy is two flat vectors. place() and undo() keep the spaces up to
/// date in time that grows with the number of spaces of the two levels touched, microseconds in practice.
///
/// A supported maximal space (thesis 3.3.1) is an empty cuboid that reaches the pallet's height limit, whose
/// base lies on the floor or wholly on tops of its exact height (tops of several boxes count together), and
/// that no other such cuboid contains. Every box inside a space that stands on the space's base keeps all
/// rules, and every box that keeps all rules lies so in a space.
///
/// With a gap, the spaces keep that gap to all boxes above their base. With a support ratio below 1 only a
/// part of a space's base needs support, so that a box inside a space may still be refused by whyNot().
class PalletState {
 public:
  /// Throws std::invalid_argument with every line of problems(rules).
  explicit PalletState(const PalletRules& rules);

  const PalletRules& rules() const { return rules_; }
  const std::vector<Placement>& placements() const { return placements_; }

  /// Ordered by the corner nearest the origin: z, then y, then x.
  const std::vector<Space>& spaces() const { return spaces_; }

  /// True when whatever stands in a space is supported: min_support_ratio is 1.
  bool fullSupport() const { return full_support_; }

  /// Empty when the placement keeps every rule; otherwise the first rule it breaks, with the numbers. Judges
  /// by the placed boxes alone, independent of the spaces.
  std::string whyNot(const Placement& placement) const;

  /// The same answer as whyNot(placement).empty(), faster.
  bool accepts(const Placement& placement) const;

  /// Adds a box. Throws std::invalid_argument with whyNot() when it breaks a rule.
  void place(const Placement& placement);

  /// Takes the last box back; false when the pallet is empty.
  bool undo();

  std::int64_t packedVolume() const { return packed_volume_; }  ///< [mm^3]
  double utilization() const;  ///< packed volume over the pallet's volume, [0, 1]

 private:
  bool levelsAreIndependent() const { return full_support_ && rules_.gap == 0; }
  void rebuildLevel(int z);
  void removeObstacle(const Placement& placement);
  void addObstacle(const Placement& placement);

  PalletRules rules_;
  bool full_support_ = true;
  std::int64_t packed_volume_ = 0;
  std::vector<Placement> placements_;
  std::vector<Space> spaces_;
};

}  // namespace mixed_palletizing::packing
