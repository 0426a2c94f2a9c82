// Source: Goncalves and Resende (2011, 2012).
//   1. A chromosome has three keys in [0, 1) for every item: its place in the sequence, the rotation it is tried in
//      first, and the rule that places it.
//   2. Decoding: items by rising first key; each goes where its rule puts it in its rotation, in any allowed rotation
//      when that one fits nowhere, and stays out when none does. Fitness is the packed volume.
//   3. The elite goes on, mutants are drawn anew, every other chromosome takes each key from a parent of the elite
//      with probability prob_elite, otherwise from one of the rest.
// The first chromosomes start from the items by falling volume, each with one rule for all. That the rule is a gene is the
// thesis' future work (5.2): a placement rule that is itself optimised.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <mixed_palletizing/packing/in_parallel.hpp>
#include <mixed_palletizing/packing/key_genetic_search.hpp>
#include <mixed_palletizing/packing/random.hpp>

#include "key_decoder.hpp"
#include "messages.hpp"

namespace mixed_palletizing::packing {

namespace {

constexpr std::size_t kBatchPerThread = 4;  ///< evaluations between two questions whether to stop

struct Chromosome {
  Keys keys;
  std::int64_t fitness = -1;  ///< packed volume [mm^3]; below 0: not evaluated
};

class KeyGeneticSearch {
 public:
  KeyGeneticSearch(const PalletState& state, const std::vector<ItemType>& types,
                   const std::vector<int>& items, const KeyGeneticOptions& options, const StopCallback& stop)
      : decoder_(state, types, items),
        pallet_volume_(volume(state.rules().size)),
        all_(state.packedVolume()),
        options_(options),
        stop_(stop),
        random_(options.seed) {
    for (const int type : items) volumes_.push_back(volume(types[static_cast<std::size_t>(type)].size));
    all_ += std::accumulate(volumes_.begin(), volumes_.end(), std::int64_t{0});
  }

  SequenceResult run(const std::function<void(const GenerationReport&)>& report) {
    start();
    bool going = evaluate();
    for (int generation = 1; going && (options_.generations == 0 || generation <= options_.generations);
         ++generation) {
      nextGeneration();
      going = evaluate();
      if (report) report({generation, options_.generations, utilization(population_.front())});
    }
    return decoder_.decode(population_.front().keys);
  }

 private:
  std::size_t population() const { return static_cast<std::size_t>(options_.population); }

  std::size_t shareOf(double share) const {
    return std::min(population(), static_cast<std::size_t>(std::lround(share * options_.population)));
  }

  double utilization(const Chromosome& chromosome) const {
    return static_cast<double>(chromosome.fitness) / static_cast<double>(pallet_volume_);
  }

  Keys randomKeys() {
    Keys keys(volumes_.size() * kKeysPerItem);
    for (double& key : keys) key = uniform01(random_);
    return keys;
  }

  void start() {
    std::vector<std::size_t> by_volume(volumes_.size());
    std::iota(by_volume.begin(), by_volume.end(), std::size_t{0});
    std::stable_sort(by_volume.begin(), by_volume.end(),
                     [this](std::size_t a, std::size_t b) { return volumes_[a] > volumes_[b]; });
    for (std::size_t i = 0; i < population(); ++i) {
      population_.push_back({randomKeys()});
      if (i >= kKeyRules.size()) continue;
      Keys& keys = population_.back().keys;
      for (std::size_t k = 0; k < by_volume.size(); ++k) {
        double* item = &keys[by_volume[k] * kKeysPerItem];
        item[0] = (static_cast<double>(k) + 0.5) / static_cast<double>(by_volume.size());
        item[1] = 0.0;
        item[2] = (static_cast<double>(i) + 0.5) / static_cast<double>(kKeyRules.size());
      }
    }
  }

  void nextGeneration() {
    const std::size_t elite = std::max<std::size_t>(1, shareOf(options_.elite_share));
    const std::size_t mutants =
        std::min(shareOf(options_.mutant_share), population() - std::min(elite, population()));
    std::vector<Chromosome> next(population_.begin(),
                                 population_.begin() + static_cast<std::ptrdiff_t>(elite));
    for (std::size_t i = 0; i < mutants; ++i) next.push_back({randomKeys()});
    while (next.size() < population()) {
      const Keys& a = population_[uniformIndex(random_, elite)].keys;
      const std::size_t rest = population() - elite;
      const Keys& b = population_[rest == 0 ? 0 : elite + uniformIndex(random_, rest)].keys;
      Keys child(a.size());
      for (std::size_t k = 0; k < child.size(); ++k) {
        child[k] = uniform01(random_) < options_.prob_elite ? a[k] : b[k];
      }
      next.push_back({std::move(child)});
    }
    population_ = std::move(next);
  }

  /// Of all that are not; sorts by fitness. False when the search has to end.
  bool evaluate() {
    bool going = true;
    std::vector<Chromosome*> batch;
    const std::size_t batch_size = kBatchPerThread * static_cast<std::size_t>(options_.threads);
    for (std::size_t i = 0; i < population_.size() && going; ++i) {
      if (population_[i].fitness < 0) {
        going = !asked_ || !stop_ || !stop_();
        asked_ = true;
        if (going) batch.push_back(&population_[i]);
      }
      if (!going || batch.size() == batch_size || i + 1 == population_.size()) evaluateBatch(batch);
    }
    std::stable_sort(population_.begin(), population_.end(),
                     [](const Chromosome& a, const Chromosome& b) { return a.fitness > b.fitness; });
    return going && population_.front().fitness < all_;
  }

  void evaluateBatch(std::vector<Chromosome*>& batch) {
    inParallel(batch.size(), options_.threads, [&](std::size_t, std::size_t i) {
      batch[i]->fitness = decoder_.packed(batch[i]->keys).packedVolume();
    });
    batch.clear();
  }

  const KeyDecoder decoder_;
  const std::int64_t pallet_volume_;  ///< [mm^3]
  std::int64_t all_;                  ///< volume when everything is packed [mm^3]
  const KeyGeneticOptions& options_;
  const StopCallback& stop_;
  Random random_;
  std::vector<std::int64_t> volumes_;  ///< of the items [mm^3]
  std::vector<Chromosome> population_;
  bool asked_ = false;
};

void requireRatio(double value, const char* name, std::vector<std::string>& lines) {
  if (value >= 0.0 && value <= 1.0) return;
  lines.push_back(std::string(name) + ": " + std::to_string(value) + ": must lie in [0, 1]");
}

}  // namespace

std::vector<std::string> problems(const KeyGeneticOptions& options) {
  constexpr int kMaxPopulation = 1000000;
  constexpr int kMaxThreads = 64;
  std::vector<std::string> lines;
  if (options.population < 1 || options.population > kMaxPopulation) {
    lines.push_back("population: " + std::to_string(options.population) + ": must lie in 1 .. " +
                    std::to_string(kMaxPopulation));
  }
  if (options.generations < 0) {
    lines.push_back("generations: " + std::to_string(options.generations) + ": must not be negative");
  }
  if (options.threads < 1 || options.threads > kMaxThreads) {
    lines.push_back("threads: " + std::to_string(options.threads) + ": must lie in 1 .. " +
                    std::to_string(kMaxThreads));
  }
  requireRatio(options.elite_share, "elite_share", lines);
  requireRatio(options.mutant_share, "mutant_share", lines);
  requireRatio(options.prob_elite, "prob_elite", lines);
  return lines;
}

SequenceResult keyGeneticSearch(const PalletState& state, const std::vector<ItemType>& types,
                                const std::vector<int>& items, const KeyGeneticOptions& options,
                                const StopCallback& stop,
                                const std::function<void(const GenerationReport&)>& report) {
  throwProblems("keyGeneticSearch: options", problems(options));
  if (options.generations == 0 && !stop) {
    throw std::invalid_argument(
        "keyGeneticSearch: stop: without a number of generations a callback must end it");
  }
  return KeyGeneticSearch(state, types, items, options, stop).run(report);
}

}  // namespace mixed_palletizing::packing
