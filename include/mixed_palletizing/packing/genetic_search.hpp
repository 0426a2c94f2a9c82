// Genetic search for a loading sequence (thesis 3.3.2, after Li, Zhao and Zhang 2014).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/placement_rule.hpp>
#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

/// Returns true when the search has to stop and answer with its best so far.
using StopCallback = std::function<bool()>;

/// Defaults of the thesis' planning experiment (4.2); its packing experiment uses population 30, 10
/// generations.
struct GeneticOptions {
  int population = 8;
  int elite = 2;
  int generations = 5;
  double prob_tournament = 0.85;  ///< prob_t: the better of two enters the mating pool
  double prob_crossover = 0.75;   ///< prob_c: a pair has offspring by crossover
  double prob_mutation = 0.5;     ///< prob_m: an offspring has two genes swapped
  PlacementRule rule = PlacementRule::kDblf;
  std::uint64_t seed = 1;
  bool stop_when_complete = true;  ///< end as soon as a sequence packs everything
};

std::vector<std::string> problems(const GeneticOptions& options);

/// A loading sequence and what it packs when every item is placed by the rule, those that fit nowhere left
/// out.
struct SequenceResult {
  std::vector<int> sequence;          ///< item types in loading order
  std::vector<Placement> placements;  ///< of the packed items only
  std::vector<int> unpacked;          ///< positions in `sequence`
  double utilization = 0.0;           ///< of the whole pallet, boxes already on it included
};

/// Packs `sequence` (type indices) on top of `state` by the rule. Throws std::invalid_argument for an index
/// outside `types`.
SequenceResult packSequence(PalletState state, const std::vector<ItemType>& types,
                            const std::vector<int>& sequence, PlacementRule rule);

struct GenerationReport {
  int generation = 0;
  int generations = 0;
  double best_utilization = 0.0;
};

struct GeneticResult {
  SequenceResult best;
  std::vector<double> best_utilizations;  ///< of all distinct sequences evaluated, descending, at most `keep`
  int generations_run = 0;
};

/// Searches the order of `items` (type indices) that packs most on top of `state`; stops early when
/// everything is packed or `stop` says so, which is asked before every evaluation but the first. `keep` is
/// how many of the best utilizations are returned. `stop` and `report` may be empty. The same input and seed
/// give the same result unless `stop` cuts in. Throws std::invalid_argument for broken options or a type
/// index outside `types`.
GeneticResult geneticSearch(const PalletState& state, const std::vector<ItemType>& types,
                            const std::vector<int>& items, const GeneticOptions& options, std::size_t keep,
                            const StopCallback& stop,
                            const std::function<void(const GenerationReport&)>& report = {});

}  // namespace mixed_palletizing::packing
