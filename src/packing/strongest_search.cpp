#include "strongest_search.hpp"

#include <algorithm>

#include <mixed_palletizing/packing/in_parallel.hpp>
namespace mixed_palletizing::packing {

namespace {

constexpr double kWidthGrowth = 1.41421356;  ///< doubles the work of a round (Araya and Riff 2014)
constexpr double kMaxWidth = 256.0;
constexpr int kMaxPopulations = 2;         ///< of the genetic search, in those of the options
constexpr int kRandomKeyGenerations = 20;  ///< in the first round, then as many more in each
constexpr int kDistanceRuleEvery = 4;      ///< rounds of the genetic search

constexpr int kLaggardEvery = 3;  ///< rounds in which what has found less has its turn
constexpr std::array<SpaceOrder, 2> kSpaceOrders{SpaceOrder::kNearest, SpaceOrder::kLowest};

std::int64_t volumeOf(const SequenceResult& found) {
  std::int64_t packed = 0;
  for (const Placement& p : found.placements) packed += volume(p.size);
  return packed;
}

}  // namespace

StrongestSearch::StrongestSearch(const Order& order, const std::vector<int>& items,
                                 const PackOptions& options, const StopCallback& stop)
    : order_(order),
      items_(items),
      options_(options),
      stop_(stop),
      second_stop_(stop),
      pallet_(order, options.spaces) {}

void StrongestSearch::run(const PackReport& report) {
  double width = 1.0;
  for (int round = 1; round == 1 || goesOn(); ++round) {
    if (!genetic_lags_ || round % kLaggardEvery == 0) geneticRound(round);
    if (!blocksServe()) {
      if (goesOn()) randomKeyRound(round);
    } else if (goesOn()) {
      blockRounds(round, static_cast<std::size_t>(width));
      width = std::min(std::max(width + 1.0, width * kWidthGrowth), kMaxWidth);
    }
    if (report) report({round, 0, utilization()});
  }
}

/// Blocks stand close; their full support keeps every other rule of support.
bool StrongestSearch::blocksServe() const { return order_.rules.gap == 0; }

double StrongestSearch::utilization() const {
  return static_cast<double>(volume_) / static_cast<double>(volume(order_.rules.size));
}

void StrongestSearch::geneticRound(int round) {
  GeneticOptions genetic = options_.genetic;
  genetic.seed = options_.seed + static_cast<std::uint64_t>(round - 1);
  genetic.rule = round % kDistanceRuleEvery == 0 ? PlacementRule::kDistance : PlacementRule::kDblf;
  genetic.population *= std::min(round, kMaxPopulations);
  const SequenceResult found = geneticSearch(pallet_, order_.types, items_, genetic, 1, stop_).best;
  take(found);
  genetic_lags_ = volumeOf(found) < volume_;
}

void StrongestSearch::randomKeyRound(int round) {
  KeyGeneticOptions genetic = options_.key_genetic;
  genetic.seed = options_.seed + static_cast<std::uint64_t>(round - 1);
  genetic.threads = options_.threads;
  genetic.generations = kRandomKeyGenerations * round;
  take(keyGeneticSearch(pallet_, order_.types, items_, genetic, stop_));
}

void StrongestSearch::blockRounds(int round, std::size_t width) {
  if (options_.threads > 1) {
    inParallel(2, 2, [&](std::size_t, std::size_t player) { playBlocks(player, player, width); });
  } else {
    const std::size_t leader = order_volumes_[1] > order_volumes_[0] ? 1 : 0;
    playBlocks(0, leader, width);
    if (round % kLaggardEvery == 1 && !blocks_[0]->complete()) playBlocks(0, 1 - leader, width);
  }
  for (const std::optional<BlockSearch>& search : blocks_) {
    if (search) takeBlocks(*search);
  }
}

void StrongestSearch::playBlocks(std::size_t player, std::size_t space_order, std::size_t width) {
  std::optional<BlockSearch>& search = blocks_[player];
  if (!search) {
    std::vector<int> counts(order_.types.size(), 0);
    for (const int type : items_) ++counts[static_cast<std::size_t>(type)];
    search.emplace(order_.rules.size, order_.types, counts, BlockSearchOptions{});
  }
  if (search->complete()) return;
  search->run(kSpaceOrders[space_order], width, player == 0 ? stop_ : second_stop_);
  order_volumes_[space_order] = search->lastVolume();
}

void StrongestSearch::takeBlocks(const BlockSearch& search) {
  if (search.bestVolume() > volume_) take(keepRules(search.bestPlacements()));
}

/// The blocks know nothing of weights: what breaks a limit is left out, then filled up item by item.
SequenceResult StrongestSearch::keepRules(const std::vector<Placement>& placements) const {
  PalletState pallet = pallet_;
  std::vector<int> counts(order_.types.size(), 0);
  for (const int type : items_) ++counts[static_cast<std::size_t>(type)];
  for (const Placement& placement : placements) {
    if (!pallet.accepts(placement)) continue;
    pallet.place(placement);
    --counts[static_cast<std::size_t>(placement.type)];
  }
  std::vector<int> rest;
  for (std::size_t type = 0; type < counts.size(); ++type) {
    rest.insert(rest.end(), static_cast<std::size_t>(counts[type]), static_cast<int>(type));
  }
  SequenceResult kept = packSequence(pallet, order_.types, rest, PlacementRule::kDblf);
  kept.placements.insert(kept.placements.begin(), pallet.placements().begin(), pallet.placements().end());
  return kept;
}

void StrongestSearch::take(const SequenceResult& found) {
  const std::int64_t packed = volumeOf(found);
  if (packed > volume_) {
    placements_ = found.placements;
    volume_ = packed;
  }
  complete_ = complete_ || found.unpacked.empty();
}

}  // namespace mixed_palletizing::packing
