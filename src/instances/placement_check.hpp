// Validity of a sequence of placements, worked out pair by pair and apart from the packing core.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::instances {

/// Area [mm^2] of the base that lies on the pallet or on tops of exactly its height, by coordinate
/// compression. Overlapping tops count once.
std::int64_t supportedArea(const packing::PalletRules& rules, const packing::Placement& placement,
                           const std::vector<packing::Placement>& below);

/// The rules `placement` breaks on top of `placed`: inside, overlap, gap, support, loadable from above.
std::vector<std::string> placementFaults(const packing::PalletRules& rules,
                                         const std::vector<packing::Placement>& placed,
                                         const packing::Placement& placement);

/// Some type's top may not carry everything.
bool limitsLoads(const packing::Order& order);

/// The limits of weight and load that the finished pallet breaks: the weight of a box and of all it carries
/// rests on the boxes below it in proportion to the areas of contact.
std::vector<std::string> loadFaults(const packing::Order& order,
                                    const std::vector<packing::Placement>& placements);

/// All of these for placements in loading order, with sizes and types against the order. Every line but that of
/// the whole weight begins with "placement <index>".
std::vector<std::string> placementFaults(const packing::Order& order,
                                         const std::vector<packing::Placement>& placements);

/// Whether a box of this size as placed can stand anywhere on `placed`. Exact with full support; with partial
/// support a place that touches no edge of another box may be missed.
bool fitsSomewhere(const packing::PalletRules& rules, const std::vector<packing::Placement>& placed,
                   const packing::Vec3& size);

/// The sizes in which a type may stand.
std::vector<packing::Vec3> allowedSizes(const packing::ItemType& type);

}  // namespace mixed_palletizing::instances
