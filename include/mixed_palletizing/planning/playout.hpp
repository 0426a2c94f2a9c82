// A possible future: the rest of an order played to its end by the policy, by the real rules of arrival.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/planning/gripper_envelope.hpp>
#include <mixed_palletizing/planning/placement_policy.hpp>

namespace mixed_palletizing::planning {

/// Where a play stands: counts per type.
struct PlayoutStart {
  packing::PalletState pallet;
  std::vector<int> visible;  ///< items that can be picked
  int n_pick = 1;            ///< so many are visible while there are enough
};

struct PlayoutEnd {
  int unpacked = 0;              ///< items
  double unpacked_volume = 0.0;  ///< [mm^3]
  double utilization = 0.0;      ///< of the pallet
  bool perfect() const { return unpacked == 0; }
};

/// Keeps its working memory between plays. Not thread safe: one for each thread.
class Playout {
 public:
  Playout(const std::vector<packing::ItemType>& types, const packing::PalletRules& rules,
          const PolicyWeights& weights, const GripperEnvelope& gripper = {});

  /// Plays until nothing is visible: of all placements of visible items the one that the policy rates best;
  /// when nothing visible fits, all of it is discarded; then the next of `to_come` (types) arrive until n_pick
  /// are visible. std::nullopt when `stop` (may be empty) cut it short.
  std::optional<PlayoutEnd> play(const PlayoutStart& start, const std::vector<int>& to_come,
                                 const packing::StopCallback& stop);

  PlacementPolicy& policy() { return policy_; }
  /// As the last play left it; in loading order.
  const packing::PalletState& pallet() const { return pallet_; }

 private:
  bool placeBest(const packing::StopCallback& stop);
  void discardVisible(PlayoutEnd& end);
  void arrive(int n_pick, const std::vector<int>& to_come, std::size_t& next);

  PlacementPolicy policy_;
  GripperEnvelope gripper_;
  packing::PalletState pallet_;
  std::vector<int> visible_;
  std::vector<int> remaining_;
  std::vector<packing::Placement> placements_;
  int visible_count_ = 0;
  bool stopped_ = false;
};

}  // namespace mixed_palletizing::planning
