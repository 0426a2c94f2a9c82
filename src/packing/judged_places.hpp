// Places in spaces where not every place keeps the rules: each must be judged.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <tuple>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>

namespace mixed_palletizing::packing {

inline bool fits(const Vec3& size, const Space& space) {
  return size.x <= space.max.x - space.min.x && size.y <= space.max.y - space.min.y &&
         size.z <= space.max.z - space.min.z;
}

/// Deepest, then bottom, then left.
inline auto dblfKey(const Vec3& origin) { return std::make_tuple(origin.z, origin.y, origin.x); }

inline std::int64_t squaredDistance(const Vec3& p) {
  const auto square = [](int v) { return static_cast<std::int64_t>(v) * v; };
  return square(p.x) + square(p.y) + square(p.z);
}

/// At the corners of the spaces and flush with the edges of the tops below, those that keep the rules, each as often as
/// spaces offer it. What is not judged when `stop` (may be empty) says so is left out.
std::vector<Placement> judgedPlacements(const PalletState& state, const std::vector<Vec3>& sizes, int type,
                                        const std::function<bool()>& stop);

/// The first of these by kDblf; none when `stop` says so.
std::optional<Placement> deepestJudged(const PalletState& state, const std::vector<Vec3>& sizes, int type,
                                       const std::function<bool()>& stop);

/// The first of these by kDistance; none when `stop` says so.
std::optional<Placement> nearestJudged(const PalletState& state, const std::vector<Vec3>& sizes, int type,
                                       const std::function<bool()>& stop);

}  // namespace mixed_palletizing::packing
