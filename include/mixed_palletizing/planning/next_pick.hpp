// Which of the available items to pick next and where to place it (thesis 3.3.3).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/gripper_envelope.hpp>
#include <mixed_palletizing/planning/placement_policy.hpp>

namespace mixed_palletizing::planning {

enum class PlanMethod {
  kDblf,  ///< the first available item that fits, by DBLF: the thesis' "only heuristic"
  kGa,    ///< future cost of every available item by a genetic search over the rest
  kBest,  ///< pairs of item and placement, judged by playing futures with sampled arrivals
};

/// Parses "dblf", "ga" or "best"; std::nullopt for another word.
std::optional<PlanMethod> planMethodFromString(const std::string& word);

/// How two lists of future costs are compared; the thesis leaves it open.
enum class CostComparison {
  kLexicographic,  ///< the best cost first, then the second, ...
  kMean,           ///< the mean of the N_cost best
};

/// Method kBest.
struct BestOptions {
  int candidates = 6;  ///< pairs whose futures are played: those that the policy rates best
  int samples = 0;     ///< futures of each pair at most; 0 = until `stop`, or kDefaultSamples without one
  int threads = 1;     ///< play futures at the same time; the decision does not depend on it
  PolicyWeights weights = tunedPolicyWeights();
  std::optional<PolicyWeights> fitted;  ///< Decision::fitted of the decision before, of the same order
  std::uint64_t seed = 1;               ///< of a session's decisions

  static constexpr int kDefaultSamples = 16;
};

std::vector<std::string> problems(const BestOptions& options);

struct PlannerOptions {
  PlanMethod method = PlanMethod::kBest;
  int n_cost =
      8;  ///< N_cost: how many of the best future costs of an item are compared (kGa) or told (kBest)
  CostComparison comparison = CostComparison::kLexicographic;
  packing::GeneticOptions genetic;
  BestOptions best;
  GripperEnvelope gripper;  ///< must find room too, with every method; the futures of kGa do without
};

std::vector<std::string> problems(const PlannerOptions& options);

/// What can be known when a decision is made: the pallet, the items at hand, and the multiset of all items
/// that are neither placed nor discarded (`remaining`, the available ones included), never the order in which
/// they come. When that multiset is known in part or not at all, `remaining` holds what is known and `forecast`
/// how many more of each type are expected: kBest then draws the rest of every future from it, kGa takes the
/// expected numbers for the real ones.
struct Situation {
  const packing::PalletState& pallet;
  const std::vector<packing::ItemType>& types;
  std::vector<int> available;         ///< type index of every item that can be picked now
  std::vector<int> remaining;         ///< count per type, available ones included
  std::vector<double> forecast = {};  ///< per type, beside `remaining`; empty = nothing more comes
};

/// What the futures that were played after a placement came to.
struct FutureEstimate {
  int playouts = 0;             ///< 0 = none was played
  double perfect_ratio = 0.0;   ///< share of them that left nothing over
  double unpacked_ratio = 0.0;  ///< mean volume left over, in volumes of the pallet
};

/// One available item as the planner sees it.
struct PickOption {
  bool feasible = false;
  packing::Placement placement;      ///< when feasible: the best that was found
  FutureEstimate future;             ///< method kBest only
  std::vector<double> future_costs;  ///< the N_cost best, ascending: 1 - utilization at the end of the order;
                                     ///< empty when nothing had to be compared or no time was left
  std::string reason;                ///< why not feasible
  bool looked_at = true;             ///< false: the time was up before
};

struct Decision {
  std::optional<std::size_t> chosen;    ///< index in Situation::available; none when nothing fits
  std::vector<PickOption> options;      ///< one for every available item
  std::optional<PolicyWeights> fitted;  ///< kBest: play this order better, where some were looked for
};

/// Decides. Equal types among the available are judged once. Deterministic for the same situation, options and seed unless `stop` cuts the search short; it
/// always answers with a feasible choice when one exists, even when `stop` is true from the start; items that were
/// not looked at by then have that as their reason. Throws
/// std::invalid_argument when `available` is not contained in `remaining` or an index is out of range.
Decision chooseNextPick(const Situation& situation, const PlannerOptions& options, std::uint64_t seed,
                        const packing::StopCallback& stop);

}  // namespace mixed_palletizing::planning
