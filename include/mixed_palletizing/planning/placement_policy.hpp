// How promising a pallet looks after a placement: a linear policy with tuned weights.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/room_sums.hpp>
#include <mixed_palletizing/planning/space_capacity.hpp>

namespace mixed_palletizing::planning {

/// What the policy looks at after a placement, each of order 1. "Remaining" are the items not yet placed, a
/// type "has n places" when n of its items fit side by side on the bases of the supported spaces, overlaps
/// counted twice, and "capacity" counts them stacked up to the height limit.
enum PolicyFeature : std::size_t {
  kUnfitRatio,          ///< share of the remaining items that fit nowhere
  kUnfitRatioCubed,     ///< its third power: the first misfit weighs less than the last
  kScarcity,            ///< mean of 1 / (1 + places) over the remaining items
  kScarcityByVolume,    ///< the same weighed by volume
  kShortage,            ///< volume of the remaining items beyond the capacity of their type
  kSpaces,              ///< number of supported spaces
  kLevels,              ///< number of base heights
  kBaseHeight,          ///< of the placed box
  kTopAboveLowest,      ///< top of the placed box above the lowest space
  kBoxVolume,           ///< of the placed box
  kBoxFootprint,        ///< of the placed box
  kBeyondPlaces,        ///< volume of the remaining items beyond the places of their type
  kLargestBase,         ///< area of the largest base of a space
  kLargestScarcity,     ///< 1 / (1 + places) of the type with the largest footprint
  kUnfitRatioByVolume,  ///< share of the remaining volume that fits nowhere
  kDeadRoom,            ///< room of the spaces that hold nothing of what remains
  kMergedTop,           ///< footprint of the placed box over the largest base its top is part of
  kFillRate,            ///< share of the spaces' room that items of a single remaining type can fill
  kPolicyFeatureCount
};

using PolicyWeights = std::array<double, kPolicyFeatureCount>;

/// The word of a feature in a file of weights.
const char* toString(PolicyFeature feature);

/// The weights of config/placement_policy.txt when this library was built.
const PolicyWeights& tunedPolicyWeights();

/// Reads lines "feature weight", '#' begins a comment. Throws std::runtime_error when the file cannot be read
/// and std::invalid_argument ("path:line: what") for an unknown, missing or doubled feature or a bad number.
PolicyWeights readPolicyWeights(const std::string& path);
/// Such a file's text; `comment` lines stand first.
std::string formatPolicyWeights(const PolicyWeights& weights, const std::vector<std::string>& comment);

/// Not thread safe: one for each thread.
class PlacementPolicy {
 public:
  /// `types` must be sound items of `rules`' pallet.
  PlacementPolicy(const std::vector<packing::ItemType>& types, const packing::PalletRules& rules,
                  const PolicyWeights& weights);

  /// From now on score() rates places of one item on `before`, which must stay as it is meanwhile; `remaining` is
  /// the count per type without the item. Linear in the number of spaces times the number of types.
  void prepare(const packing::PalletState& before, const std::vector<int>& remaining);

  /// How promising the pallet would be with `placement`, which the pallet must accept; higher is better. Linear in the
  /// spaces of the two levels that change where PalletState::levelsAfter() tells them.
  double score(const packing::Placement& placement);

  /// The values that score() weighs, by their definition: `after` is the pallet with `placement` on it.
  PolicyWeights features(const packing::PalletState& after, const packing::Placement& placement,
                         const std::vector<int>& remaining);

  /// Weighs by these from now on.
  void weigh(const PolicyWeights& weights) { weights_ = weights; }

  std::size_t typeCount() const { return volumes_.size(); }
  /// The distinct sizes in which items of a type may stand.
  const std::vector<packing::Vec3>& sizes(int type) const { return sizes_[static_cast<std::size_t>(type)]; }
  /// [mm^3]
  double itemVolume(int type) const { return volumes_[static_cast<std::size_t>(type)]; }
  double palletVolume() const { return pallet_volume_; }  ///< [mm^3]

 private:
  struct LevelSums {
    int z = 0;
    RoomSums sums;
  };

  double weighed(const PolicyWeights& f) const;
  void addSpace(const packing::Space& space, const std::vector<int>& remaining, RoomSums& sums);
  int sumUnchanged(int base, int top);
  void addDemand(const std::vector<int>& remaining, PolicyWeights& f) const;
  PolicyWeights featuresOf(const packing::Placement& placement, const std::vector<int>& remaining, int levels,
                           int lowest, double largest_top) const;

  std::vector<std::vector<packing::Vec3>> sizes_;
  std::vector<double> volumes_;     ///< [mm^3] per type
  std::vector<double> footprints_;  ///< [mm^2] per type, the largest of its sizes
  packing::Vec3 pallet_size_;
  double pallet_volume_;
  PolicyWeights weights_;
  SpaceCapacity capacity_;
  RoomSums after_;  ///< of the pallet being judged

  // Of the pallet given to prepare().
  const packing::PalletState* before_ = nullptr;
  std::vector<int> remaining_;
  RoomSums all_;
  std::vector<LevelSums> levels_;  ///< the first level_count_ count, from the lowest on
  std::size_t level_count_ = 0;
  packing::ChangedLevels changed_;
  packing::PalletState trial_;
};

}  // namespace mixed_palletizing::planning
