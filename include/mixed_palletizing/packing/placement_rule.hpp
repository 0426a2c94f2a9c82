// Rules that choose where in the supported spaces an item goes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

enum class PlacementRule {
  kDblf,      ///< deepest, then bottom, then left with fill (Karabulut and Inceoglu 2004)
  kDistance,  ///< nearest to the pallet's origin (thesis 4.2.3)
  kContact,  ///< at a corner of a space where the largest share of the sides touches boxes or the pallet's sides
  kBestFit,  ///< at a corner of the space whose base leaves the narrowest strip beside the item
};

/// Parses "dblf", "distance", "contact" or "best_fit"; std::nullopt for another word.
std::optional<PlacementRule> placementRuleFromString(const std::string& word);

/// The place the rule gives an item of `type` (index `type_index`), or std::nullopt when it fits nowhere.
/// Ties go to the lower, then the nearer to the origin, then the earlier of orientations(type). With fullSupport() the
/// place is the best of all valid ones by kDblf and kDistance, and the best of all corners of the spaces by the others;
/// without, the best of those that cornerPlacements() tries. Throws
/// std::invalid_argument for a negative index or a size that is not positive.
std::optional<Placement> findPlacement(const PalletState& state, const ItemType& type, int type_index,
                                       PlacementRule rule);

/// The same for an item given by the sizes in which it may stand: for callers that place many items. Without
/// fullSupport() the search may take long: it finds nothing when `stop` says so.
std::optional<Placement> findPlacement(const PalletState& state, const std::vector<Vec3>& sizes,
                                       int type_index, PlacementRule rule,
                                       const std::function<bool()>& stop = {});

/// Every placement of the item at the corner of a supported space nearest to the pallet's origin, each once.
/// Where the state has no fullSupport() also flush with the edges of the tops below, as far as the rules allow.
std::vector<Placement> cornerPlacements(const PalletState& state, const ItemType& type, int type_index);

/// The same for an item given by the sizes in which it may stand; when `stop` says so, only those found so far.
std::vector<Placement> cornerPlacements(const PalletState& state, const std::vector<Vec3>& sizes,
                                        int type_index, const std::function<bool()>& stop = {});

/// What is still to be placed, as far as the thesis' pruning rules (3.3.1) need it: the smallest volume, the
/// smallest height and the smallest side of a footprint over all orientations of the remaining items.
struct RemainingLimits {
  std::int64_t volume = 0;  ///< [mm^3]
  int footprint_side = 0;   ///< [mm]
  int height = 0;           ///< [mm]
};

/// `counts[i]` items of `types[i]` remain. With nothing left, limits that no space can hold. Throws
/// std::invalid_argument when the two differ in size.
RemainingLimits remainingLimits(const std::vector<ItemType>& types, const std::vector<int>& counts);

/// The spaces that can hold something of what remains by volume and by dimensions. The state itself keeps
/// every space: a small one may grow into a useful one when a neighbour reaches its height.
std::vector<Space> usefulSpaces(const PalletState& state, const RemainingLimits& limits);

}  // namespace mixed_palletizing::packing
