#include "../unit/packing/definition_play.hpp"
#include "invariants.hpp"

namespace mixed_palletizing::torture {
namespace {

using packing::Order;
using packing::PalletState;
using packing::SpaceKind;
using packing::test::draw;
using packing::test::Game;

constexpr std::size_t kMostBoxes = 40;

/// Of ten games six have full support and no gap, one a gap, one empty maximal spaces, two partial support.
Game play(std::mt19937_64& rng) {
  const auto kind = rng() % 10;
  Order order;
  order.rules.size = {draw(rng, 3, 9), draw(rng, 3, 8), draw(rng, 2, 7)};
  if (kind == 6) order.rules.gap = draw(rng, 1, 2);
  if (kind == 7) order.rules.size = {draw(rng, 3, 6), draw(rng, 3, 5), draw(rng, 2, 5)};
  if (kind >= 8) {
    order.rules.min_support_ratio = 0.1 * draw(rng, 3, 9);
    order.rules.gap = draw(rng, 0, 1);
    order.rules.overhang = draw(rng, 0, 2);
  }
  const PalletState pallet(order, kind == 7 ? SpaceKind::kEmpty : SpaceKind::kSupported);
  return packing::test::playAgainstDefinition(pallet, rng, kMostBoxes);
}

}  // namespace

Cases placeAtRandom(long placements, std::uint64_t seed) {
  Cases cases;
  for (std::uint64_t game = 0; cases.tried < placements; ++game) {
    std::mt19937_64 rng(seed + game);
    const Game played = play(rng);
    const std::string fault =
        played.fault.empty() ? "" : "seed " + std::to_string(seed + game) + ": " + played.fault;
    cases.add(fault, played.placed);
  }
  return cases;
}

}  // namespace mixed_palletizing::torture
