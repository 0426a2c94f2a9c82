// The boxes on a pallet and the empty supported maximal spaces (ESMS) around them.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

/// Value type: copy it to try something. place() and undo() keep the spaces up to date.
///
/// A supported maximal space (thesis 3.3.1) is an empty cuboid that reaches the pallet's height limit, whose
/// base lies on the floor or wholly on tops of its exact height (tops of several boxes count together), and
/// that no other such cuboid contains.
class PalletState {
 public:
  /// Throws std::invalid_argument for a size that is not positive, a negative gap or a support ratio outside
  /// (0, 1].
  explicit PalletState(const PalletRules& rules);

  const PalletRules& rules() const { return rules_; }
  const std::vector<Placement>& placements() const { return placements_; }
  const std::vector<Space>& spaces() const { return spaces_; }

  /// Empty when the placement keeps every rule; otherwise the first rule it breaks, with the numbers.
  std::string whyNot(const Placement& placement) const;

  /// Adds a box. Throws std::invalid_argument with whyNot() when it breaks a rule.
  void place(const Placement& placement);

  /// Takes the last box back; false when the pallet is empty.
  bool undo();

  std::int64_t packedVolume() const;  ///< [mm^3]
  double utilization() const;         ///< packed volume over the pallet's volume, [0, 1]

 private:
  PalletRules rules_;
  std::vector<Placement> placements_;
  std::vector<Space> spaces_;
};

}  // namespace mixed_palletizing::packing
