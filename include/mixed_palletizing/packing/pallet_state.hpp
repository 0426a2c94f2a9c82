// The boxes on a pallet and the empty supported maximal spaces (ESMS) around them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/load_book.hpp>
#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

/// Which spaces a pallet keeps.
enum class SpaceKind {
  kSupported,  ///< empty supported maximal spaces (thesis 3.3.1)
  kEmpty,      ///< empty maximal spaces (Lai and Chan 1997): every maximal empty cuboid, supported or not
};

/// The spaces of the two levels that a placement changes.
struct ChangedLevels {
  std::vector<Space> base;  ///< at its base height
  std::vector<Space> top;   ///< at the height of its top
};

/// Value type: copy it to try something; a copy is two flat vectors. place() and undo() keep the spaces up to
/// date in time that grows with the number of spaces of the two levels touched, microseconds in practice.
///
/// A supported maximal space (thesis 3.3.1) is an empty cuboid that reaches the pallet's height limit, whose
/// base lies on the floor or wholly on tops of its exact height (tops of several boxes count together), and
/// that no other such cuboid contains. Every box inside a space that stands on the space's base keeps all
/// rules, and every box that keeps all rules lies so in a space.
///
/// With a gap, the spaces keep that gap to all boxes above their base. With a support ratio below 1 only a
/// part of a space's base needs support, so that a box inside a space may still be refused by whyNot(); so it
/// may where types limit the load on their tops, and in empty maximal spaces.
class PalletState {
 public:
  /// A pallet on which weights do not matter. Throws std::invalid_argument with every line of problems(rules).
  explicit PalletState(const PalletRules& rules);

  /// The pallet of an order, on which the limits of weight and load hold too; Placement::type is the index in
  /// order.types. Throws std::invalid_argument with every line of problems(order.rules).
  explicit PalletState(const Order& order, SpaceKind kind = SpaceKind::kSupported);

  const PalletRules& rules() const { return rules_; }
  const std::vector<Placement>& placements() const { return placements_; }

  /// Ordered by the corner nearest the origin: z, then y, then x.
  const std::vector<Space>& spaces() const { return spaces_; }

  SpaceKind spaceKind() const { return kind_; }

  /// True when every box keeps all rules wherever it stands on the base of a space, its weight apart.
  bool fullSupport() const { return full_support_ && kind_ == SpaceKind::kSupported && !loads_.limitsTops(); }

  /// An item of this type would not make the pallet too heavy.
  bool carriesWeightOf(int type) const { return loads_.carriesWeightOf(type); }

  /// What rests on the top of every box [kg]; empty when no limit of weight is given.
  const std::vector<double>& loads() const { return loads_.loads(); }

  /// Empty when the placement keeps every rule; otherwise the first rule it breaks, with the numbers. Judges
  /// by the placed boxes alone, independent of the spaces.
  std::string whyNot(const Placement& placement) const;

  /// The same answer as whyNot(placement).empty(), faster.
  bool accepts(const Placement& placement) const;

  /// The same for a placement that lies in one of the spaces, on its base: much faster where fullSupport() is not.
  bool acceptsInSpace(const Placement& placement) const;

  /// Adds a box. Throws std::invalid_argument with whyNot() when it breaks a rule.
  void place(const Placement& placement);

  /// What place(placement) would leave of the levels that it changes, in no order; all other spaces stay as they
  /// are. False, and nothing told, where it would change more: with a gap, partial support or empty maximal spaces.
  /// The placement must be accepted.
  bool levelsAfter(const Placement& placement, ChangedLevels& changed) const;

  /// Takes the last box back; false when the pallet is empty.
  bool undo();

  std::int64_t packedVolume() const { return packed_volume_; }  ///< [mm^3]
  double utilization() const;  ///< packed volume over the pallet's volume, [0, 1] without an overhang

 private:
  bool levelsAreIndependent() const { return full_support_ && rules_.gap == 0; }
  void rebuildLevel(int z);
  void removeObstacle(const Placement& placement);
  void cutOutOfEmpty(const Placement& placement);
  void restoreEmpty();
  void addObstacle(const Placement& placement);

  PalletRules rules_;
  SpaceKind kind_ = SpaceKind::kSupported;
  bool full_support_ = true;
  std::int64_t packed_volume_ = 0;
  std::vector<Placement> placements_;
  std::vector<Space> spaces_;
  std::vector<Space> removed_;             ///< kEmpty: by every box, one after the other
  std::vector<std::size_t> removed_ends_;  ///< of every box, in removed_
  LoadBook loads_;
};

}  // namespace mixed_palletizing::packing
