#include "strongest_search.hpp"

#include <algorithm>
#include <utility>

namespace mixed_palletizing::packing {

namespace {

constexpr double kWidthGrowth = 1.41421356;  ///< doubles the work of a round (Araya and Riff 2014)
constexpr double kMaxWidth = 256.0;
constexpr int kMaxPopulations = 2;     ///< of the genetic search, in those of the options
constexpr int kDistanceRuleEvery = 4;  ///< rounds of the genetic search

}  // namespace

StrongestSearch::StrongestSearch(const Order& order, const std::vector<int>& items,
                                 const PackOptions& options, const StopCallback& stop)
    : order_(order), items_(items), options_(options), stop_(stop), pallet_(order, options.spaces) {}

void StrongestSearch::run(const PackReport& report) {
  double width = 1.0;
  for (int round = 1; round == 1 || (!complete_ && !stop_()); ++round) {
    geneticRound(round);
    if (blocksServe() && !complete_ && !stop_()) {
      blockRound(SpaceOrder::kNearest, static_cast<std::size_t>(width));
      blockRound(SpaceOrder::kLowest, static_cast<std::size_t>(width));
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
  std::int64_t packed = 0;
  for (const Placement& p : found.placements) packed += volume(p.size);
  if (packed > volume_) take(found.placements, packed);
  complete_ = complete_ || found.unpacked.empty();
}

void StrongestSearch::blockRound(SpaceOrder space_order, std::size_t width) {
  if (!blocks_) {
    std::vector<int> counts(order_.types.size(), 0);
    for (const int type : items_) ++counts[static_cast<std::size_t>(type)];
    blocks_.emplace(order_.rules.size, order_.types, counts, BlockSearchOptions{});
  }
  blocks_->run(space_order, width, stop_);
  if (blocks_->bestVolume() <= volume_) return;
  const SequenceResult kept = keepRules(blocks_->bestPlacements());
  std::int64_t packed = 0;
  for (const Placement& p : kept.placements) packed += volume(p.size);
  if (packed > volume_) take(kept.placements, packed);
  complete_ = complete_ || kept.unpacked.empty();
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

void StrongestSearch::take(std::vector<Placement> placements, std::int64_t packed) {
  placements_ = std::move(placements);
  volume_ = packed;
}

}  // namespace mixed_palletizing::packing
