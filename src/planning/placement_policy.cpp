// A pallet is judged by what is still to come: can each remaining item be placed, how many places has each type
// left, how much room is lost. The features are cheap, their weights are tuned by policy_tuning.hpp.
#include <algorithm>

#include <mixed_palletizing/planning/placement_policy.hpp>

namespace mixed_palletizing::planning {
namespace {

// Scales that bring the features to the order of 1.
constexpr double kManySpaces = 16.0;
constexpr double kManyLevels = 8.0;
constexpr double kLargeVolumeRatio = 1.0 / 16.0;
constexpr double kLargeAreaRatio = 1.0 / 4.0;
constexpr double kMuchRoomRatio = 1.0 / 8.0;

double area(const packing::Vec3& size) { return static_cast<double>(size.x) * size.y; }

}  // namespace

PlacementPolicy::PlacementPolicy(const std::vector<packing::ItemType>& types,
                                 const packing::PalletRules& rules, const PolicyWeights& weights)
    : pallet_size_(rules.size),
      pallet_volume_(static_cast<double>(packing::volume(rules.size))),
      weights_(weights),
      capacity_({}),
      places_(types.size()),
      capacities_(types.size()) {
  for (const packing::ItemType& type : types) {
    sizes_.push_back(packing::orientations(type));
    volumes_.push_back(static_cast<double>(packing::volume(type.size)));
    double largest = 0.0;
    for (const packing::Vec3& size : sizes_.back()) largest = std::max(largest, area(size));
    footprints_.push_back(largest);
  }
  capacity_ = SpaceCapacity(sizes_);
}

double PlacementPolicy::score(const packing::PalletState& after, const packing::Placement& placement,
                              const std::vector<int>& remaining) {
  const PolicyWeights f = features(after, placement, remaining);
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += weights_[i] * f[i];
  return sum;
}

PolicyWeights PlacementPolicy::features(const packing::PalletState& after,
                                        const packing::Placement& placement,
                                        const std::vector<int>& remaining) {
  PolicyWeights f{};
  addSpaces(after, placement, remaining, f);
  addDemand(remaining, f);
  addTop(after, placement, f);
  f[kBaseHeight] = static_cast<double>(placement.origin.z) / pallet_size_.z;
  f[kBoxVolume] = static_cast<double>(packing::volume(placement.size)) / (pallet_volume_ * kLargeVolumeRatio);
  f[kBoxFootprint] = area(placement.size) / (area(pallet_size_) * kLargeAreaRatio);
  return f;
}

/// What the free room looks like; leaves places_ and capacities_ for addDemand().
void PlacementPolicy::addSpaces(const packing::PalletState& after, const packing::Placement& placement,
                                const std::vector<int>& remaining, PolicyWeights& f) {
  const std::size_t types = volumes_.size();
  std::fill(places_.begin(), places_.end(), 0);
  std::fill(capacities_.begin(), capacities_.end(), 0);
  double dead_room = 0.0;
  double all_room = 0.0;
  double fillable = 0.0;
  double largest_base = 0.0;
  int levels = 0;
  int last_level = -1;
  for (const packing::Space& space : after.spaces()) {
    const packing::Vec3 room = space.size();
    const int* row = capacity_.of(room);
    for (std::size_t t = 0; t < types; ++t) {
      places_[t] += row[t];
      capacities_[t] += row[types + t];
    }
    double fill = 0.0;  // by items of one type
    for (std::size_t t = 0; t < types; ++t) {
      fill = std::max(fill, std::min(row[types + t], remaining[t]) * volumes_[t]);
    }
    const double room_volume = area(room) * room.z;
    largest_base = std::max(largest_base, area(room));
    all_room += room_volume;
    fillable += fill;
    if (fill == 0.0) dead_room += room_volume;
    if (space.min.z != last_level) ++levels;
    last_level = space.min.z;
  }
  const int lowest = after.spaces().empty() ? pallet_size_.z : after.spaces().front().min.z;
  f[kSpaces] = static_cast<double>(after.spaces().size()) / kManySpaces;
  f[kLevels] = levels / kManyLevels;
  f[kTopAboveLowest] = static_cast<double>(placement.origin.z + placement.size.z - lowest) / pallet_size_.z;
  f[kLargestBase] = largest_base / area(pallet_size_);
  f[kFillRate] = all_room > 0.0 ? fillable / all_room : 0.0;
  const bool any_left = std::any_of(remaining.begin(), remaining.end(), [](int count) { return count > 0; });
  f[kDeadRoom] = any_left ? dead_room / (pallet_volume_ * kMuchRoomRatio) : 0.0;
}

/// How the top of the placed box joins its neighbours.
void PlacementPolicy::addTop(const packing::PalletState& after, const packing::Placement& placement,
                             PolicyWeights& f) const {
  const packing::Vec3& from = placement.origin;
  const packing::Vec3& size = placement.size;
  double largest = area(size);
  for (const packing::Space& space : after.spaces()) {
    if (space.min.z != from.z + size.z || space.min.x >= from.x + size.x || space.max.x <= from.x ||
        space.min.y >= from.y + size.y || space.max.y <= from.y) {
      continue;
    }
    largest = std::max(largest, area(space.size()));
  }
  f[kMergedTop] = area(size) / largest;
}

/// What remains against the places it has.
void PlacementPolicy::addDemand(const std::vector<int>& remaining, PolicyWeights& f) const {
  double items = 0.0, item_volume = 0.0, unfit = 0.0, unfit_volume = 0.0;
  double scarcity = 0.0, scarce_volume = 0.0, shortage = 0.0, beyond_places = 0.0;
  double largest_footprint = 0.0, largest_volume = 0.0, largest_scarcity = 0.0;
  for (std::size_t t = 0; t < volumes_.size(); ++t) {
    if (remaining[t] <= 0) continue;
    const double count = remaining[t];
    const double all = count * volumes_[t];
    const double scarce = 1.0 / (1.0 + places_[t]);
    items += count;
    item_volume += all;
    if (places_[t] == 0) {
      unfit += count;
      unfit_volume += all;
    }
    scarcity += count * scarce;
    scarce_volume += all * scarce;
    shortage += volumes_[t] * std::max(0, remaining[t] - capacities_[t]);
    beyond_places += volumes_[t] * std::max(0, remaining[t] - places_[t]);
    if (footprints_[t] > largest_footprint ||
        (footprints_[t] == largest_footprint && volumes_[t] > largest_volume)) {
      largest_footprint = footprints_[t];
      largest_volume = volumes_[t];
      largest_scarcity = scarce;
    }
  }
  if (items == 0.0) return;
  const double unfit_ratio = unfit / items;
  f[kUnfitRatio] = unfit_ratio;
  f[kUnfitRatioCubed] = unfit_ratio * unfit_ratio * unfit_ratio;
  f[kScarcity] = scarcity / items;
  f[kScarcityByVolume] = scarce_volume / item_volume;
  f[kShortage] = shortage / item_volume;
  f[kBeyondPlaces] = beyond_places / item_volume;
  f[kLargestScarcity] = largest_scarcity;
  f[kUnfitRatioByVolume] = unfit_volume / item_volume;
}

}  // namespace mixed_palletizing::planning
