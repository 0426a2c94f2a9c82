// Every vector of weights plays the same orders of an iteration; cross_entropy follows the best of them.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <mixed_palletizing/packing/in_parallel.hpp>
#include <mixed_palletizing/planning/playout.hpp>
#include <mixed_palletizing/planning/policy_tuning.hpp>

#include "cross_entropy.hpp"
#include "future_value.hpp"

namespace mixed_palletizing::planning {
namespace {

constexpr double kNoise = 0.02;  ///< added to every deviation at the start
constexpr std::size_t kLeastElite = 4;

}  // namespace

std::vector<std::string> problems(const TuningOptions& options) {
  std::vector<std::string> found;
  const auto require = [&found](bool holds, const std::string& line) {
    if (!holds) found.push_back(line);
  };
  require(options.iterations >= 1, "iterations: " + std::to_string(options.iterations) + ": at least 1");
  require(options.population >= static_cast<int>(kLeastElite),
          "population: " + std::to_string(options.population) + ": at least " + std::to_string(kLeastElite));
  require(options.elite_ratio > 0.0 && options.elite_ratio <= 1.0,
          "elite_ratio: " + std::to_string(options.elite_ratio) + ": must lie in (0, 1]");
  require(options.spread > 0.0 && std::isfinite(options.spread),
          "spread: " + std::to_string(options.spread) + ": must be positive");
  require(options.threads >= 1, "threads: " + std::to_string(options.threads) + ": at least 1");
  return found;
}

PolicyScore playPolicy(const std::vector<TuningOrder>& orders, const PolicyWeights& weights) {
  PolicyScore score;
  for (const TuningOrder& order : orders) {
    Playout playout(order.order.types, order.order.rules, weights);
    const PlayoutStart start{packing::PalletState(order.order), std::vector<int>(order.order.types.size(), 0),
                             order.n_pick};
    const PlayoutEnd end = *playout.play(start, order.arrival, {});
    score.value += futureValue(end, playout.policy().palletVolume());
    score.perfect_ratio += end.perfect() ? 1.0 : 0.0;
    score.unpacked += end.unpacked;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(orders.size(), 1));
  return {score.value / count, score.perfect_ratio / count, score.unpacked / count};
}

PolicyWeights tunePolicy(const TuningOptions& options, const TuningOrders& orders,
                         const std::function<void(const TuningReport&)>& report) {
  const std::vector<std::string> found = problems(options);
  if (!found.empty()) throw std::invalid_argument("tunePolicy: options: " + found.front());
  CrossEntropy search(options.start, options.spread, kNoise, options.seed);
  const std::size_t elite =
      std::max(kLeastElite, static_cast<std::size_t>(options.elite_ratio * options.population));
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const std::vector<TuningOrder> sample = orders(iteration);
    const std::vector<PolicyWeights> drawn = search.draw(static_cast<std::size_t>(options.population));
    std::vector<PolicyScore> scores(drawn.size());
    packing::inParallel(drawn.size(), options.threads,
                        [&](std::size_t, std::size_t i) { scores[i] = playPolicy(sample, drawn[i]); });
    std::vector<TriedWeights> tried;
    for (std::size_t i = 0; i < drawn.size(); ++i) tried.push_back({drawn[i], scores[i].value});
    const auto best = std::max_element(tried.begin(), tried.end(),
                                       [](const auto& a, const auto& b) { return a.value < b.value; });
    const TuningReport now{iteration, scores.front(), best->value};
    search.follow(std::move(tried), elite);
    if (report) report(now);
  }
  return search.mean();
}

}  // namespace mixed_palletizing::planning
