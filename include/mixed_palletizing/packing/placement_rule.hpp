// Rules that choose where in the supported spaces an item goes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

enum class PlacementRule {
  kDblf,      ///< deepest, then bottom, then left with fill (Karabulut and Inceoglu 2004)
  kDistance,  ///< nearest to the pallet's origin (thesis 4.2.3)
};

/// Parses "dblf" or "distance"; std::nullopt for another word.
std::optional<PlacementRule> placementRuleFromString(const std::string& word);

/// The place the rule gives an item of `type` (index `type_index`), or std::nullopt when it fits nowhere.
std::optional<Placement> findPlacement(const PalletState& state, const ItemType& type, int type_index,
                                       PlacementRule rule);

/// Every placement of the item at the corner of a supported space nearest to the pallet's origin.
std::vector<Placement> cornerPlacements(const PalletState& state, const ItemType& type, int type_index);

}  // namespace mixed_palletizing::packing
