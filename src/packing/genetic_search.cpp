// Source: thesis 3.3.2, after Li, Zhao and Zhang (2014).
//   1. Population: four chromosomes sorted by volume, length, width and height, largest first; the rest
//   random.
//   2. Fitness: utilization when the sequence is packed item by item by the placement rule.
//   3. The E best go on (elitism). A mating pool is filled by tournaments of two, the better one winning with
//      prob_t, and paired.
//   4. A pair has two offspring by crossover with prob_c, otherwise both go on unchanged. (The thesis' text
//   says
//      the opposite, its list of constants "probability of crossover" 0.75; the latter is Li's.)
//   5. An offspring has two genes swapped with prob_m.
// A gene is the index of an item, not its type, so a chromosome is a permutation; sequences that are equal in
// types are packed once.
#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/random.hpp>

#include "crossover.hpp"
#include "messages.hpp"
#include "sequence_packer.hpp"

namespace mixed_palletizing::packing {

namespace {

struct Chromosome {
  Genes genes;
  double fitness = 0.0;
};

class GeneticSearch {
 public:
  GeneticSearch(const PalletState& state, const std::vector<ItemType>& types, const std::vector<int>& items,
                const GeneticOptions& options, const StopCallback& stop)
      : types_(types),
        items_(items),
        options_(options),
        stop_(stop),
        random_(options.seed),
        packer_(state, types, options.rule) {
    packer_.check(items, "geneticSearch");
  }

  GeneticResult run(std::size_t keep, const std::function<void(const GenerationReport&)>& report);

 private:
  void start();
  bool evaluate(Chromosome& chromosome);
  bool evaluateAll(std::vector<Chromosome>& chromosomes, std::size_t first);
  std::vector<Chromosome> nextGeneration();
  const Chromosome& tournament();
  void mate(const Chromosome& a, const Chromosome& b, std::vector<Chromosome>& children);
  Genes sortedGenes(int key) const;
  std::vector<int> sequenceOf(const Genes& genes) const;
  void sortByFitness();

  const std::vector<ItemType>& types_;
  const std::vector<int>& items_;
  const GeneticOptions& options_;
  const StopCallback& stop_;
  Random random_;
  SequencePacker packer_;
  std::vector<Chromosome> population_;
  std::map<std::vector<int>, double> evaluated_;
  std::vector<int> best_sequence_;
  double best_fitness_ = -1.0;
  bool complete_ = false;  ///< some sequence packed everything and that is enough
};

std::vector<int> GeneticSearch::sequenceOf(const Genes& genes) const {
  std::vector<int> sequence(genes.size());
  std::transform(genes.begin(), genes.end(), sequence.begin(),
                 [this](int gene) { return items_[static_cast<std::size_t>(gene)]; });
  return sequence;
}

/// Genes by falling volume (key 0), length, width or height (keys 1 to 3); equal items stay together.
Genes GeneticSearch::sortedGenes(int key) const {
  const auto rank = [&](int gene) {
    const int type = items_[static_cast<std::size_t>(gene)];
    const Vec3& size = types_[static_cast<std::size_t>(type)].size;
    const std::int64_t keys[] = {volume(size), size.x, size.y, size.z};
    return std::make_tuple(-keys[key], -keys[0], type, gene);
  };
  Genes genes(items_.size());
  std::iota(genes.begin(), genes.end(), 0);
  std::sort(genes.begin(), genes.end(), [&](int a, int b) { return rank(a) < rank(b); });
  return genes;
}

void GeneticSearch::start() {
  for (int i = 0; i < options_.population; ++i) {
    if (i < 4) {
      population_.push_back({sortedGenes(i), 0.0});
      continue;
    }
    Genes genes(items_.size());
    std::iota(genes.begin(), genes.end(), 0);
    shuffle(genes, random_);
    population_.push_back({genes, 0.0});
  }
}

/// False when the search has to end before this evaluation.
bool GeneticSearch::evaluate(Chromosome& chromosome) {
  if (complete_) return false;
  std::vector<int> sequence = sequenceOf(chromosome.genes);
  const auto known = evaluated_.find(sequence);
  if (known != evaluated_.end()) {
    chromosome.fitness = known->second;
    return true;
  }
  if (!evaluated_.empty() && stop_ && stop_()) return false;
  complete_ = packer_.pack(sequence) && options_.stop_when_complete;
  chromosome.fitness = packer_.state().utilization();
  if (chromosome.fitness > best_fitness_) {
    best_fitness_ = chromosome.fitness;
    best_sequence_ = sequence;
  }
  evaluated_.emplace(std::move(sequence), chromosome.fitness);
  return true;
}

bool GeneticSearch::evaluateAll(std::vector<Chromosome>& chromosomes, std::size_t first) {
  for (std::size_t i = first; i < chromosomes.size(); ++i) {
    if (!evaluate(chromosomes[i])) return false;
  }
  return true;
}

const Chromosome& GeneticSearch::tournament() {
  const std::size_t a = uniformIndex(random_, population_.size());
  const std::size_t b = uniformIndex(random_, population_.size());
  const bool better_wins = uniform01(random_) < options_.prob_tournament;
  return population_[better_wins ? std::min(a, b)
                                 : std::max(a, b)];  // sorted: the smaller index is the better
}

void GeneticSearch::mate(const Chromosome& a, const Chromosome& b, std::vector<Chromosome>& children) {
  const std::size_t n = a.genes.size();
  if (n < 2 || uniform01(random_) >= options_.prob_crossover) {
    children.push_back(a);
    children.push_back(b);
    return;
  }
  const std::size_t cut_a = uniformIndex(random_, n + 1);
  const std::size_t cut_b = uniformIndex(random_, n + 1);
  const std::size_t first = std::min(cut_a, cut_b);
  const std::size_t last = std::max(cut_a, cut_b);
  for (Genes genes : {crossover(a.genes, b.genes, first, last), crossover(b.genes, a.genes, first, last)}) {
    if (uniform01(random_) < options_.prob_mutation) {
      std::swap(genes[uniformIndex(random_, n)], genes[uniformIndex(random_, n)]);
    }
    children.push_back({std::move(genes), 0.0});
  }
}

std::vector<Chromosome> GeneticSearch::nextGeneration() {
  const std::size_t elite = static_cast<std::size_t>(options_.elite);
  std::vector<Chromosome> next(population_.begin(), population_.begin() + options_.elite);
  std::vector<const Chromosome*> pool;
  while (elite + pool.size() < population_.size()) pool.push_back(&tournament());
  std::size_t i = 0;
  for (; i + 1 < pool.size(); i += 2) mate(*pool[i], *pool[i + 1], next);
  if (i < pool.size()) next.push_back(*pool[i]);  // no partner left: goes on unchanged
  return next;
}

void GeneticSearch::sortByFitness() {
  std::stable_sort(population_.begin(), population_.end(),
                   [](const Chromosome& a, const Chromosome& b) { return a.fitness > b.fitness; });
}

GeneticResult GeneticSearch::run(std::size_t keep,
                                 const std::function<void(const GenerationReport&)>& report) {
  GeneticResult result;
  start();
  bool going = evaluateAll(population_, 0);
  for (int generation = 1; going && generation <= options_.generations; ++generation) {
    sortByFitness();
    std::vector<Chromosome> next = nextGeneration();
    going = evaluateAll(next, static_cast<std::size_t>(options_.elite));
    if (going) result.generations_run = generation;
    population_ = std::move(next);
    if (report) report({generation, options_.generations, best_fitness_});
  }
  result.best = packSequence(packer_.start(), types_, best_sequence_, options_.rule);
  for (const auto& entry : evaluated_) result.best_utilizations.push_back(entry.second);
  std::sort(result.best_utilizations.rbegin(), result.best_utilizations.rend());
  if (result.best_utilizations.size() > keep) result.best_utilizations.resize(keep);
  return result;
}

void requireRatio(double value, const char* name, std::vector<std::string>& lines) {
  if (value >= 0.0 && value <= 1.0) return;
  lines.push_back(std::string(name) + ": " + std::to_string(value) + ": must lie in [0, 1]");
}

}  // namespace

std::vector<std::string> problems(const GeneticOptions& options) {
  std::vector<std::string> lines;
  if (options.population < 1 || options.population > 1000000) {
    lines.push_back("population: " + std::to_string(options.population) + ": must lie in 1 .. 1000000");
  }
  if (options.elite < 0 || options.elite > options.population) {
    lines.push_back("elite: " + std::to_string(options.elite) + ": must lie in 0 .. population");
  }
  if (options.generations < 0) {
    lines.push_back("generations: " + std::to_string(options.generations) + ": must not be negative");
  }
  requireRatio(options.prob_tournament, "prob_tournament", lines);
  requireRatio(options.prob_crossover, "prob_crossover", lines);
  requireRatio(options.prob_mutation, "prob_mutation", lines);
  return lines;
}

GeneticResult geneticSearch(const PalletState& state, const std::vector<ItemType>& types,
                            const std::vector<int>& items, const GeneticOptions& options, std::size_t keep,
                            const StopCallback& stop,
                            const std::function<void(const GenerationReport&)>& report) {
  throwProblems("geneticSearch: options", problems(options));
  GeneticSearch search(state, types, items, options, stop);
  return search.run(keep, report);
}

}  // namespace mixed_palletizing::packing
