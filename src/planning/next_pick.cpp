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

PickOption notLookedAt() {
  PickOption option;
  option.looked_at = false;
  option.reason = "not looked at: the time was up";
  return option;
}

/// Of a type; `stop` may cut the search for its place short.
PickOption optionOf(const Situation& situation, int type, const PlannerOptions& options,
                    const packing::StopCallback& stop) {
  const packing::ItemType& item = situation.types[static_cast<std::size_t>(type)];
  const auto placement =
      findReachable(situation.pallet, item, type, options.genetic.rule, options.gripper, stop);
  if (!placement && stop && stop()) return notLookedAt();
  PickOption option;
  if (placement) {
    option.feasible = true;
    option.placement = *placement;
  } else {
    option.reason = whyNowhere(situation.pallet, item, type);
  }
  return option;
}

std::vector<int> distinctTypes(const Situation& situation) {
  std::vector<int> types;
  std::vector<char> known(situation.types.size(), 0);
  for (const int type : situation.available) {
    if (known[static_cast<std::size_t>(type)] == 0) types.push_back(type);
    known[static_cast<std::size_t>(type)] = 1;
  }
  return types;
}

/// Once something fits, the rest is only looked at while there is time. When the time is up before, those go first that
/// fit most easily: light and small.
Decision feasibleOptions(const Situation& situation, const PlannerOptions& options,
                         const packing::StopCallback& stop) {
  const auto ease = [&situation](int type) {
    const packing::ItemType& item = situation.types[static_cast<std::size_t>(type)];
    return std::make_tuple(item.weight_kg, packing::volume(item.size), type);
  };
  std::vector<int> types = distinctTypes(situation);
  std::vector<PickOption> of_type(situation.types.size());
  bool any = false;
  bool sorted = false;
  for (auto type = types.begin(); type != types.end(); ++type) {
    const bool late = stop && stop();
    if (late && !any && !sorted) {
      std::sort(type, types.end(), [&ease](int a, int b) { return ease(a) < ease(b); });
      sorted = true;
    }
    PickOption& option = of_type[static_cast<std::size_t>(*type)];
    option = late && any ? notLookedAt()
                         : optionOf(situation, *type, options, any ? stop : packing::StopCallback());
    any = any || option.feasible;
  }
  Decision decision;
  decision.options.reserve(situation.available.size());
  for (const int type : situation.available) {
    decision.options.push_back(of_type[static_cast<std::size_t>(type)]);
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
