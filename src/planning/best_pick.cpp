// Source: thesis 3.3.3 (Fig. 3.21) for the question; the answer differs from it in what is compared and how:
// 1. Every available item is tried at every corner of every supported space, not at DBLF's place alone; the
//    policy rates the pallets that follow, the best `candidates` pairs enter a race.
// 2. The order of arrival of the rest is unknown: it is drawn again and again, and every pair plays the same
//    draws to the end of the order by the real rules (so many visible, discarded when none of them fits), the
//    policy choosing. Playing with the future order known would be too optimistic.
// 3. Pairs clearly behind the leader drop out (playout_race); the one with the best mean value is chosen.
// 4. Where hardly any future becomes perfect and time is left, the policy is fitted to the order and the pairs race again
//    (fitted_race, order_policy).
#include "best_pick.hpp"

#include <algorithm>
#include <limits>

#include <mixed_palletizing/planning/playout.hpp>

#include "fitted_race.hpp"

namespace mixed_palletizing::planning {
namespace {

std::vector<int> feasibleTypes(const Situation& situation, const Decision& decision) {
  std::vector<int> types;
  for (std::size_t i = 0; i < situation.available.size(); ++i) {
    if (decision.options[i].feasible) types.push_back(situation.available[i]);
  }
  std::sort(types.begin(), types.end());
  types.erase(std::unique(types.begin(), types.end()), types.end());
  return types;
}

std::vector<double> bestCosts(const std::vector<PlayoutEnd>& ends, int n_cost) {
  std::vector<double> costs;
  for (const PlayoutEnd& end : ends) costs.push_back(1.0 - end.utilization);
  std::sort(costs.begin(), costs.end());
  costs.resize(std::min(costs.size(), static_cast<std::size_t>(n_cost)));
  return costs;
}

FutureEstimate estimateOf(const std::vector<PlayoutEnd>& ends, double pallet_volume) {
  FutureEstimate estimate;
  estimate.playouts = static_cast<int>(ends.size());
  if (ends.empty()) return estimate;
  for (const PlayoutEnd& end : ends) {
    if (end.perfect()) estimate.perfect_ratio += 1.0;
    estimate.unpacked_ratio += end.unpacked_volume / pallet_volume;
  }
  estimate.perfect_ratio /= estimate.playouts;
  estimate.unpacked_ratio /= estimate.playouts;
  return estimate;
}

PickOption optionOf(const PlayoutRace::Runner& runner, double pallet_volume, int n_cost) {
  PickOption option;
  option.feasible = true;
  option.placement = runner.placement;
  option.future = estimateOf(runner.ends, pallet_volume);
  option.future_costs = bestCosts(runner.ends, n_cost);
  return option;
}

/// For every type its pair that raced best, or the one rated best when none of it raced.
void tellOptions(const Situation& situation, const std::vector<ScoredPlacement>& pairs,
                 const PlayoutRace& race, int n_cost, Decision& decision) {
  const auto pallet_volume = static_cast<double>(packing::volume(situation.pallet.rules().size));
  std::vector<PickOption> of_type(situation.types.size());
  for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {
    PickOption& option = of_type[static_cast<std::size_t>(pair->placement.type)];
    option.feasible = true;
    option.placement = pair->placement;
  }
  std::vector<double> best(situation.types.size(), -std::numeric_limits<double>::infinity());
  for (const PlayoutRace::Runner& runner : race.runners()) {
    const auto type = static_cast<std::size_t>(runner.placement.type);
    const double value = race.meanValue(runner);
    if (runner.ends.empty() || value <= best[type]) continue;
    best[type] = value;
    of_type[type] = optionOf(runner, pallet_volume, n_cost);
  }
  // One that dropped out early may look better than the winner, which played more futures.
  const PlayoutRace::Runner& winner = race.runners()[race.leader()];
  of_type[static_cast<std::size_t>(winner.placement.type)] = optionOf(winner, pallet_volume, n_cost);
  for (std::size_t i = 0; i < situation.available.size(); ++i) {
    const PickOption& known = of_type[static_cast<std::size_t>(situation.available[i])];
    if (known.feasible) decision.options[i] = known;  // else DBLF's place stands
  }
}

}  // namespace

void chooseByPlayouts(const Situation& situation, const PlannerOptions& options, std::uint64_t seed,
                      const packing::StopCallback& stop, Decision& decision) {
  const std::vector<int> types = feasibleTypes(situation, decision);
  if (types.empty()) return;
  FittedRace fitted(situation, types, options, seed, stop);
  int chosen_type = *std::max_element(types.begin(), types.end(), [&](int a, int b) {
    return fitted.policy().itemVolume(a) < fitted.policy().itemVolume(b);
  });
  if (fitted.result().race) {
    std::optional<int> samples;
    if (options.best.samples > 0 || !stop) samples = std::max(options.best.samples, 0);
    if (samples == 0) samples = BestOptions::kDefaultSamples;
    fitted.run(samples);
    const FittedRace::Heat& heat = fitted.result();
    tellOptions(situation, heat.pairs, *heat.race, options.n_cost, decision);
    chosen_type = heat.race->runners()[heat.race->leader()].placement.type;
    if (heat.weights != options.best.weights) decision.fitted = heat.weights;
  }
  decision.chosen = static_cast<std::size_t>(
      std::find(situation.available.begin(), situation.available.end(), chosen_type) -
      situation.available.begin());
}

}  // namespace mixed_palletizing::planning
