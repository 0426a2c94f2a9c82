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

/// Whether the space begins on the top of the placed box, or on more than that.
bool standsOn(const packing::Placement& placed, const packing::Space& space) {
  const packing::Vec3& from = placed.origin;
  const packing::Vec3& size = placed.size;
  return space.min.z == from.z + size.z && space.min.x < from.x + size.x && space.max.x > from.x &&
         space.min.y < from.y + size.y && space.max.y > from.y;
}

}  // namespace

PlacementPolicy::PlacementPolicy(const std::vector<packing::ItemType>& types,
                                 const packing::PalletRules& rules, const PolicyWeights& weights)
    : pallet_size_(rules.size),
      pallet_volume_(static_cast<double>(packing::volume(rules.size))),
      weights_(weights),
      capacity_({}),
      trial_(rules) {
  for (const packing::ItemType& type : types) {
    sizes_.push_back(packing::orientations(type));
    volumes_.push_back(static_cast<double>(packing::volume(type.size)));
    double largest = 0.0;
    for (const packing::Vec3& size : sizes_.back()) largest = std::max(largest, area(size));
    footprints_.push_back(largest);
  }
  capacity_ = SpaceCapacity(sizes_);
}

void PlacementPolicy::prepare(const packing::PalletState& before, const std::vector<int>& remaining) {
  before_ = &before;
  remaining_ = remaining;
  all_.clear(volumes_.size());
  level_count_ = 0;
  for (const packing::Space& space : before.spaces()) {
    if (level_count_ == 0 || levels_[level_count_ - 1].z != space.min.z) {
      if (level_count_ > 0) all_.add(levels_[level_count_ - 1].sums);
      if (levels_.size() == level_count_) levels_.emplace_back();
      levels_[level_count_].z = space.min.z;
      levels_[level_count_++].sums.clear(volumes_.size());
    }
    addSpace(space, remaining_, levels_[level_count_ - 1].sums);
  }
  if (level_count_ > 0) all_.add(levels_[level_count_ - 1].sums);
}

double PlacementPolicy::score(const packing::Placement& placement) {
  if (!before_->levelsAfter(placement, changed_)) {
    trial_ = *before_;
    trial_.place(placement);
    return weighed(features(trial_, placement, remaining_));
  }
  const int base = placement.origin.z;
  const int top = base + placement.size.z;
  after_ = all_;
  int levels = sumUnchanged(base, top);
  double largest_top = 0.0;
  for (const packing::Space& space : changed_.base) addSpace(space, remaining_, after_);
  for (const packing::Space& space : changed_.top) {
    addSpace(space, remaining_, after_);
    if (standsOn(placement, space)) largest_top = std::max(largest_top, area(space.size()));
  }
  levels += (changed_.base.empty() ? 0 : 1) + (changed_.top.empty() ? 0 : 1);
  int lowest = pallet_size_.z;
  for (std::size_t i = level_count_; i-- > 0;) {
    if (levels_[i].z != base || !changed_.base.empty()) lowest = levels_[i].z;
  }
  if (!changed_.top.empty()) lowest = std::min(lowest, top);
  return weighed(featuresOf(placement, remaining_, levels, lowest, largest_top));
}

/// Leaves in after_ the levels other than these; so many there are.
int PlacementPolicy::sumUnchanged(int base, int top) {
  int levels = 0;
  after_.largest_base = 0.0;
  for (std::size_t i = 0; i < level_count_; ++i) {
    const LevelSums& level = levels_[i];
    if (level.z == base || level.z == top) {
      after_.subtract(level.sums);
    } else {
      after_.largest_base = std::max(after_.largest_base, level.sums.largest_base);
      ++levels;
    }
  }
  return levels;
}

void PlacementPolicy::addSpace(const packing::Space& space, const std::vector<int>& remaining,
                               RoomSums& sums) {
  sums.addSpace(space, capacity_.of(space.size()), volumes_, remaining);
}

double PlacementPolicy::weighed(const PolicyWeights& f) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += weights_[i] * f[i];
  return sum;
}

PolicyWeights PlacementPolicy::features(const packing::PalletState& after,
                                        const packing::Placement& placement,
                                        const std::vector<int>& remaining) {
  after_.clear(volumes_.size());
  int levels = 0;
  int last_level = -1;
  double largest_top = 0.0;
  for (const packing::Space& space : after.spaces()) {
    addSpace(space, remaining, after_);
    if (space.min.z != last_level) ++levels;
    last_level = space.min.z;
    if (standsOn(placement, space)) largest_top = std::max(largest_top, area(space.size()));
  }
  const int lowest = after.spaces().empty() ? pallet_size_.z : after.spaces().front().min.z;
  return featuresOf(placement, remaining, levels, lowest, largest_top);
}

/// Of the pallet whose spaces after_ sums; `largest_top` is the largest base of a space over the placed box [mm^2].
PolicyWeights PlacementPolicy::featuresOf(const packing::Placement& placement,
                                          const std::vector<int>& remaining, int levels, int lowest,
                                          double largest_top) const {
  PolicyWeights f{};
  addDemand(remaining, f);
  f[kSpaces] = after_.spaces / kManySpaces;
  f[kLevels] = levels / kManyLevels;
  f[kBaseHeight] = static_cast<double>(placement.origin.z) / pallet_size_.z;
  f[kTopAboveLowest] = static_cast<double>(placement.origin.z + placement.size.z - lowest) / pallet_size_.z;
  f[kBoxVolume] = static_cast<double>(packing::volume(placement.size)) / (pallet_volume_ * kLargeVolumeRatio);
  f[kBoxFootprint] = area(placement.size) / (area(pallet_size_) * kLargeAreaRatio);
  f[kLargestBase] = after_.largest_base / area(pallet_size_);
  const bool any_left = std::any_of(remaining.begin(), remaining.end(), [](int count) { return count > 0; });
  f[kDeadRoom] = any_left ? after_.dead / (pallet_volume_ * kMuchRoomRatio) : 0.0;
  f[kMergedTop] = area(placement.size) / std::max(area(placement.size), largest_top);
  f[kFillRate] = after_.room > 0.0 ? after_.fillable / after_.room : 0.0;
  return f;
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
    const double scarce = 1.0 / (1.0 + after_.places[t]);
    items += count;
    item_volume += all;
    if (after_.places[t] == 0) {
      unfit += count;
      unfit_volume += all;
    }
    scarcity += count * scarce;
    scarce_volume += all * scarce;
    shortage += volumes_[t] * std::max(0, remaining[t] - after_.capacities[t]);
    beyond_places += volumes_[t] * std::max(0, remaining[t] - after_.places[t]);
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
