// Plays the arrival of an order's items against the planner, a few items visible at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>

namespace mixed_palletizing::planning {

/// What the planner is told of the items still to come.
enum class PlayKnowledge {
  kSet,       ///< how many of each type, never their order
  kForecast,  ///< the same numbers, but as means: every future draws its own
  kTypes,     ///< the types only: as many of each as fill the free volume in equal shares are expected
  kOrder,     ///< every arrival, as no planner knows it: what knowing would be worth; kBest only
};

/// Parses "set", "forecast", "types" or "order"; std::nullopt for another word.
std::optional<PlayKnowledge> playKnowledgeFromString(const std::string& word);

struct PlayOptions {
  PlannerOptions planner;
  PlayKnowledge knowledge = PlayKnowledge::kSet;
  int n_pick = 3;          ///< N_pick: items visible at a time
  double budget_ms = 0.0;  ///< per decision; 0 = bounded by iterations only, hence reproducible
  std::uint64_t seed = 1;
};

std::vector<std::string> problems(const PlayOptions& options);

struct PlayedPlacement {
  int item = 0;  ///< index in the arrival
  packing::Placement placement;
  std::vector<int> available;  ///< indices in the arrival that were visible
};

struct PlayResult {
  std::vector<PlayedPlacement> placements;  ///< in loading order
  std::vector<int> unpacked;                ///< indices in the arrival that were discarded
  double utilization = 0.0;
  std::vector<double> decision_ms;  ///< of every decision
};

/// Called after every decision with the number of items that are through and the number of all.
using PlayProgress = std::function<void(int done, int total)>;

/// The first n_pick items of `arrival` (type indices of `order`) are available; after each placed one the
/// next joins at the end; when none of the available fits anywhere they are all discarded and the next n_pick
/// arrive. The planner knows of the items to come what options.knowledge says. Throws
/// std::invalid_argument for a bad order, bad options, or an arrival that is not made of the order's items.
PlayResult playArrivals(const packing::Order& order, const std::vector<int>& arrival,
                        const PlayOptions& options, const PlayProgress& progress = {});

}  // namespace mixed_palletizing::planning
