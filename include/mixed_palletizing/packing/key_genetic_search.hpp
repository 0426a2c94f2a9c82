// Biased random-key genetic search (Goncalves and Resende 2011, 2012): sequence, rotations and placement rules are
// optimised together.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>

namespace mixed_palletizing::packing {

/// Shares and probability as in Goncalves and Resende (2012), their table 2.
struct KeyGeneticOptions {
  int population = 60;
  double elite_share = 0.1;    ///< goes on unchanged
  double mutant_share = 0.15;  ///< is new and random in every generation
  double prob_elite = 0.7;     ///< a key of an offspring comes from the parent of the elite
  int generations = 0;         ///< 0 = until everything is packed or the search is told to stop
  int threads = 1;             ///< that evaluate; the result is the same with any number
  std::uint64_t seed = 1;
};

std::vector<std::string> problems(const KeyGeneticOptions& options);

/// Searches the packing of `items` (type indices) on top of `state` that packs most. `stop` is asked before every
/// evaluation but the first, by the calling thread, and may be empty when `generations` is not 0. In the result
/// `unpacked` are positions in `sequence`. The same input and seed give the same result unless `stop` cuts in.
/// Throws std::invalid_argument for broken options or a type index outside `types`.
SequenceResult keyGeneticSearch(const PalletState& state, const std::vector<ItemType>& types,
                                const std::vector<int>& items, const KeyGeneticOptions& options,
                                const StopCallback& stop,
                                const std::function<void(const GenerationReport&)>& report = {});

}  // namespace mixed_palletizing::packing
