// Packs sequences of one set of types by a placement rule, again and again on the same start.
#pragma once

#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/placement_rule.hpp>

namespace mixed_palletizing::packing {

class SequencePacker {
 public:
  /// Keeps no reference to `types`.
  SequencePacker(const PalletState& start, const std::vector<ItemType>& types, PlacementRule rule);

  /// Throws std::invalid_argument naming `function` when an index lies outside the types.
  void check(const std::vector<int>& sequence, const char* function) const;

  /// Packs what fits; true when everything did. The indices must be good. The result is in state().
  bool pack(const std::vector<int>& sequence);

  const PalletState& start() const { return start_; }
  const PalletState& state() const { return state_; }
  const std::vector<int>& unpacked() const { return unpacked_; }  ///< positions in the last sequence

 private:
  PalletState start_;
  PalletState state_;
  PlacementRule rule_;
  std::vector<std::vector<Vec3>> sizes_;  ///< orientations of every type
  std::vector<int> unpacked_;
  std::vector<std::size_t> refused_at_;  ///< of a type: boxes on the pallet when it last fitted nowhere
};

}  // namespace mixed_palletizing::packing
