// Checks, what fits at all, and the way to the methods.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include <mixed_palletizing/packing/placement_rule.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>

#include "best_pick.hpp"
#include "candidates.hpp"
#include "genetic_pick.hpp"
#include "scored_placements.hpp"

namespace mixed_palletizing::planning {
namespace {

/// The place the rule gives an item among those that the gripper reaches, as far as `stop` lets it look.
std::optional<packing::Placement> findReachable(const packing::PalletState& pallet,
                                                const packing::ItemType& item, int type,
                                                packing::PlacementRule rule, const GripperEnvelope& gripper,
                                                const packing::StopCallback& stop) {
  const std::vector<packing::Vec3> sizes = packing::orientations(item);
  const auto found = packing::findPlacement(pallet, sizes, type, rule, stop);
  if (!found || clears(gripper, pallet, *found)) return found;
  std::vector<packing::Placement> placements;
  placementsOf(pallet, sizes, type, Trials::kThorough, gripper, placements, stop);
  const auto key = [](const packing::Placement& p) {
    return std::make_tuple(p.origin.z, p.origin.y, p.origin.x);
  };
  const auto best = std::min_element(placements.begin(), placements.end(),
                                     [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return best == placements.end() ? std::nullopt : std::make_optional(*best);
}

/// Once something fits, the rest is only looked at while there is time.
Decision feasibleOptions(const Situation& situation, const PlannerOptions& options,
                         const packing::StopCallback& stop) {
  Decision decision;
  bool any = false;
  std::vector<std::optional<std::size_t>> first_of_type(situation.types.size());
  decision.options.reserve(situation.available.size());
  for (std::size_t i = 0; i < situation.available.size(); ++i) {
    const int type = situation.available[i];
    std::optional<std::size_t>& first = first_of_type[static_cast<std::size_t>(type)];
    if (first) {
      decision.options.push_back(decision.options[*first]);
      continue;
    }
    first = i;
    const packing::ItemType& item = situation.types[static_cast<std::size_t>(type)];
    PickOption option;
    const packing::StopCallback may_stop = any ? stop : packing::StopCallback();
    const auto time_is_up = [&may_stop] { return may_stop && may_stop(); };
    const auto placement = time_is_up() ? std::nullopt
                                        : findReachable(situation.pallet, item, type, options.genetic.rule,
                                                        options.gripper, may_stop);
    if (placement) {
      option.feasible = true;
      option.placement = *placement;
      any = true;
    } else if (time_is_up()) {
      option.looked_at = false;
      option.reason = "not looked at: the time was up";
    } else {
      option.reason = whyNowhere(situation.pallet, item, type);
    }
    decision.options.push_back(std::move(option));
  }
  return decision;
}

void check(const Situation& situation, const PlannerOptions& options) {
  const std::vector<std::string> found = problems(options);
  if (!found.empty()) throw std::invalid_argument("chooseNextPick: options: " + found.front());
  if (situation.remaining.size() != situation.types.size()) {
    throw std::invalid_argument("chooseNextPick: remaining: " + std::to_string(situation.remaining.size()) +
                                " counts for " + std::to_string(situation.types.size()) + " types");
  }
  if (!situation.forecast.empty() && situation.forecast.size() != situation.types.size()) {
    throw std::invalid_argument("chooseNextPick: forecast: " + std::to_string(situation.forecast.size()) +
                                " counts for " + std::to_string(situation.types.size()) + " types");
  }
  for (const double expected : situation.forecast) {
    if (expected >= 0.0 && expected <= packing::kMaxItems) continue;
    throw std::invalid_argument("chooseNextPick: forecast: " + std::to_string(expected) + " is no count");
  }
  const std::string problem = availableProblem(situation.available, situation.remaining);
  if (!problem.empty()) throw std::invalid_argument("chooseNextPick: " + problem);
}

void chooseFirst(Decision& decision) {
  const auto first = std::find_if(decision.options.begin(), decision.options.end(),
                                  [](const PickOption& option) { return option.feasible; });
  if (first != decision.options.end()) {
    decision.chosen = static_cast<std::size_t>(first - decision.options.begin());
  }
}

}  // namespace

std::optional<PlanMethod> planMethodFromString(const std::string& word) {
  if (word == "dblf") return PlanMethod::kDblf;
  if (word == "ga") return PlanMethod::kGa;
  if (word == "best") return PlanMethod::kBest;
  return std::nullopt;
}

std::vector<std::string> problems(const PlannerOptions& options) {
  std::vector<std::string> found = packing::problems(options.genetic);
  if (options.n_cost < 1)
    found.push_back("n_cost: " + std::to_string(options.n_cost) + ": must be at least 1");
  for (const std::string& line : problems(options.best)) found.push_back("best." + line);
  for (const std::string& line : problems(options.gripper)) found.push_back("gripper." + line);
  return found;
}

std::vector<std::string> problems(const BestOptions& options) {
  std::vector<std::string> found;
  const auto atLeast = [&found](const std::string& name, int value, int least) {
    if (value >= least) return;
    found.push_back(name + ": " + std::to_string(value) + ": must be at least " + std::to_string(least));
  };
  atLeast("candidates", options.candidates, 1);
  atLeast("samples", options.samples, 0);
  atLeast("threads", options.threads, 1);
  const auto finite = [](const PolicyWeights& weights) {
    return std::all_of(weights.begin(), weights.end(), [](double weight) { return std::isfinite(weight); });
  };
  if (!finite(options.weights)) found.emplace_back("weights: every weight must be finite");
  if (options.fitted && !finite(*options.fitted)) found.emplace_back("fitted: every weight must be finite");
  return found;
}

Decision chooseNextPick(const Situation& situation, const PlannerOptions& options, std::uint64_t seed,
                        const packing::StopCallback& stop) {
  check(situation, options);
  Decision decision = feasibleOptions(situation, options, stop);
  switch (options.method) {
    case PlanMethod::kDblf:
      chooseFirst(decision);
      break;
    case PlanMethod::kGa:
      chooseByGeneticSearch(withExpected(situation), options, seed, stop, decision);
      break;
    case PlanMethod::kBest:
      chooseByPlayouts(situation, options, seed, stop, decision);
      break;
  }
  return decision;
}

}  // namespace mixed_palletizing::planning
