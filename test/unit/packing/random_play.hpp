// Random placements for the tests of this room.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>

#include <mixed_palletizing/packing/pallet_state.hpp>

namespace mixed_palletizing::packing::test {

inline int draw(std::mt19937_64& rng, int low, int high) {
  return low + static_cast<int>(rng() % static_cast<std::uint64_t>(high - low + 1));
}

/// A box within a random space, mostly at one of its corners, sometimes anywhere on its base. The state must
/// have a space.
inline Placement randomPlacement(const PalletState& state, std::mt19937_64& rng, int largest) {
  const Space space = state.spaces()[rng() % state.spaces().size()];
  const Vec3 room = space.size();
  Placement p;
  p.size = {draw(rng, 1, std::min(largest, room.x)), draw(rng, 1, std::min(largest, room.y)),
            draw(rng, 1, std::min(largest, room.z))};
  const auto offset = [&](int free) {
    return rng() % 3 == 0 ? draw(rng, 0, free) : (rng() % 2 == 0 ? 0 : free);
  };
  p.origin = {space.min.x + offset(room.x - p.size.x), space.min.y + offset(room.y - p.size.y), space.min.z};
  return p;
}

/// A pallet with up to `boxes` random boxes on it.
inline PalletState randomPallet(const PalletRules& rules, std::mt19937_64& rng, int boxes, int largest) {
  PalletState state(rules);
  for (int i = 0; i < boxes && !state.spaces().empty(); ++i) {
    const Placement p = randomPlacement(state, rng, largest);
    if (state.accepts(p)) state.place(p);
  }
  return state;
}

}  // namespace mixed_palletizing::packing::test
