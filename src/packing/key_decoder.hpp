// Turns random keys into a packing.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/placement_rule.hpp>

namespace mixed_palletizing::packing {

/// For every item three keys in [0, 1): its place in the sequence, the rotation it is tried in first, and the
/// rule that places it.
using Keys = std::vector<double>;

constexpr std::size_t kKeysPerItem = 3;
constexpr std::array<PlacementRule, 4> kKeyRules{PlacementRule::kDblf, PlacementRule::kDistance,
                                                 PlacementRule::kBestFit, PlacementRule::kContact};

/// May be used by several threads at a time.
class KeyDecoder {
 public:
  /// Keeps a reference to `items`. Throws std::invalid_argument for a type index outside `types`.
  KeyDecoder(const PalletState& start, const std::vector<ItemType>& types, const std::vector<int>& items);

  /// The pallet of a chromosome; `unpacked`, when given, gets the positions in its sequence.
  PalletState packed(const Keys& keys, std::vector<int>* unpacked = nullptr) const;

  SequenceResult decode(const Keys& keys) const;

 private:
  std::vector<std::size_t> sequenceOf(const Keys& keys) const;
  std::optional<Placement> place(const PalletState& state, const Keys& keys, std::size_t item) const;

  PalletState start_;
  const std::vector<int>& items_;
  std::vector<std::vector<Vec3>> sizes_;  ///< orientations of every type
};

}  // namespace mixed_palletizing::packing
