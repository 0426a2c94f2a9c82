// The choice of the next box, thesis 3.3.3 (Fig. 3.21):
// 1. Every available item is placed temporarily by DBLF; those that fit nowhere keep the reason.
// 2. A genetic search over the items that then remain, their order taken as free, keeps the N_cost best
//    utilizations; the costs of the item are 1 - utilization.
// 3. The item with the best costs is picked. The thesis leaves open how lists of costs are compared; here from
//    the best cost on, what is equal in all of them is decided for the larger item, then for the one that came
//    first. Over 600 orders each of 600 and 1200 mm this packed 58.0 and 35.7 % perfectly, the mean of the
//    costs 56.8 and 36.8 %: no difference beyond chance, and a list can be explained by its first difference.
// When so few items remain that all their sequences can be tried with the effort of the search, they are: the
// costs of the last boxes are exact. Every placement is made on a pallet that holds all before it (the thesis
// placed its last three boxes at one place, 4.2.5).
#include "genetic_pick.hpp"

#include <algorithm>
#include <numeric>

#include "candidates.hpp"

namespace mixed_palletizing::planning {
namespace {

using packing::StopCallback;

/// Number of distinct orders of the items, or `limit` + 1 when there are more.
std::size_t sequenceCount(const std::vector<int>& items, std::size_t limit) {
  std::size_t count = 1;
  std::size_t run = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {  // items are sorted by type
    run = i > 0 && items[i] == items[i - 1] ? run + 1 : 1;
    count = count * (i + 1) / run;  // stays an integer: a product of binomials
    if (count > limit) return limit + 1;
  }
  return count;
}

/// The `keep` best costs over all sequences of the sorted items.
std::vector<double> exactCosts(const packing::PalletState& pallet, const Situation& situation,
                               std::vector<int> items, const PlannerOptions& options) {
  std::vector<double> costs;
  do {
    costs.push_back(1.0 -
                    packing::packSequence(pallet, situation.types, items, options.genetic.rule).utilization);
  } while (std::next_permutation(items.begin(), items.end()));
  std::sort(costs.begin(), costs.end());
  costs.resize(std::min(costs.size(), static_cast<std::size_t>(options.n_cost)));
  return costs;
}

std::vector<double> futureCosts(const Situation& situation, const packing::Placement& placement,
                                const PlannerOptions& options, std::uint64_t seed, const StopCallback& stop) {
  packing::PalletState pallet = situation.pallet;
  pallet.place(placement);
  const std::vector<int> items = restItems(situation.remaining, placement.type);
  const auto effort = static_cast<std::size_t>(options.genetic.population) *
                      static_cast<std::size_t>(options.genetic.generations + 1);
  if (sequenceCount(items, effort) <= effort) return exactCosts(pallet, situation, items, options);
  packing::GeneticOptions genetic = options.genetic;
  genetic.stop_when_complete =
      false;            // of two complete futures, the one with more complete sequences is safer
  genetic.seed = seed;  // the same for all candidates, so that they differ by themselves and not by luck
  const packing::GeneticResult found = packing::geneticSearch(pallet, situation.types, items, genetic,
                                                              static_cast<std::size_t>(options.n_cost), stop);
  std::vector<double> costs;
  for (const double utilization : found.best_utilizations) costs.push_back(1.0 - utilization);
  return costs;
}

bool costsLess(const std::vector<double>& a, const std::vector<double>& b, CostComparison comparison) {
  if (comparison == CostComparison::kMean) {
    const auto mean = [](const std::vector<double>& costs) {
      return std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(costs.size());
    };
    return mean(a) < mean(b);
  }
  // A list may be shorter when its item has fewer sequences left; its last cost stands for the missing ones.
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const double cost_a = a[std::min(i, a.size() - 1)];
    const double cost_b = b[std::min(i, b.size() - 1)];
    if (cost_a != cost_b) return cost_a < cost_b;
  }
  return false;
}

/// Index of the available item that the costs favour; those without costs come last.
std::optional<std::size_t> bestOption(const Decision& decision, const Situation& situation,
                                      CostComparison comparison) {
  const auto itemVolume = [&](std::size_t i) {
    return packing::volume(situation.types[static_cast<std::size_t>(situation.available[i])].size);
  };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < decision.options.size(); ++i) {
    if (!decision.options[i].feasible) continue;
    const auto better = [&](std::size_t a, std::size_t b) {
      const std::vector<double>& costs_a = decision.options[a].future_costs;
      const std::vector<double>& costs_b = decision.options[b].future_costs;
      if (costs_a.empty() != costs_b.empty()) return costs_b.empty();
      if (!costs_a.empty() && costsLess(costs_a, costs_b, comparison)) return true;
      if (!costs_a.empty() && costsLess(costs_b, costs_a, comparison)) return false;
      return itemVolume(a) > itemVolume(b);
    };
    if (!best || better(i, *best)) best = i;
  }
  return best;
}

/// Step 2 for every distinct feasible item, unless there is only one and hence nothing to compare.
void addCosts(const Situation& situation, const PlannerOptions& options, std::uint64_t seed,
              const StopCallback& stop, Decision& decision) {
  std::vector<std::size_t> distinct;
  for (std::size_t i = 0; i < decision.options.size(); ++i) {
    if (decision.options[i].feasible && firstOfType(situation.available, i) == i) distinct.push_back(i);
  }
  if (distinct.size() < 2) return;
  for (const std::size_t i : distinct) {
    if (stop && stop()) return;
    decision.options[i].future_costs =
        futureCosts(situation, decision.options[i].placement, options, seed, stop);
  }
  for (std::size_t i = 0; i < decision.options.size(); ++i) {
    decision.options[i].future_costs = decision.options[firstOfType(situation.available, i)].future_costs;
  }
}

}  // namespace

void chooseByGeneticSearch(const Situation& situation, const PlannerOptions& options, std::uint64_t seed,
                           const StopCallback& stop, Decision& decision) {
  addCosts(situation, options, seed, stop, decision);
  decision.chosen = bestOption(decision, situation, options.comparison);
}

}  // namespace mixed_palletizing::planning
