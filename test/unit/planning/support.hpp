// Orders for the tests of planning.
#pragma once

#include <algorithm>
#include <random>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::planning::test {

inline int draw(std::mt19937_64& rng, int low, int high) {
  return low + static_cast<int>(rng() % static_cast<std::uint64_t>(high - low + 1));
}

/// A sound order of one to six types for a pallet of about 1200 x 800 x 600 mm.
inline packing::Order randomOrder(std::mt19937_64& rng) {
  packing::Order order;
  order.rules.size = {draw(rng, 800, 1200), draw(rng, 600, 800), draw(rng, 300, 900)};
  if (draw(rng, 0, 3) == 0) order.rules.gap = draw(rng, 1, 10);
  if (draw(rng, 0, 3) == 0) order.rules.min_support_ratio = 0.7;
  const int types = draw(rng, 1, 6);
  for (int i = 0; i < types; ++i) {
    packing::ItemType type;
    type.name = "type" + std::to_string(i);
    type.size = {draw(rng, 100, 600), draw(rng, 100, 600), draw(rng, 50, 300)};
    const int rotations = draw(rng, 0, 2);
    if (rotations == 1) type.rotations = packing::Rotations::yawOnly();
    if (rotations == 2) type.rotations = packing::Rotations::any();
    if (draw(rng, 0, 1) == 0) type.weight_kg = draw(rng, 1, 20);
    order.types.push_back(type);
    order.counts.push_back(draw(rng, 1, 6));
  }
  return order;
}

inline std::vector<int> shuffledItems(const packing::Order& order, std::mt19937_64& rng) {
  std::vector<int> items;
  for (std::size_t i = 0; i < order.counts.size(); ++i) {
    items.insert(items.end(), static_cast<std::size_t>(order.counts[i]), static_cast<int>(i));
  }
  std::shuffle(items.begin(), items.end(), rng);
  return items;
}

}  // namespace mixed_palletizing::planning::test
