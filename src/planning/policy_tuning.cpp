// Source: the cross-entropy method (Rubinstein 1999), with added noise that fades (Szita and Lorincz 2006), so
// that the deviations do not shrink before the means have arrived.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/packing/in_parallel.hpp>
#include <mixed_palletizing/packing/random.hpp>
#include <mixed_palletizing/planning/playout.hpp>
#include <mixed_palletizing/planning/policy_tuning.hpp>

#include "future_value.hpp"

namespace mixed_palletizing::planning {
namespace {

constexpr double kKept = 0.1;          ///< share of the old deviation in the new
constexpr double kNoise = 0.02;        ///< added to every deviation at the start ...
constexpr double kNoiseHalving = 7.0;  ///< ... and halved every so many iterations
constexpr std::size_t kLeastElite = 4;

struct Tried {
  PolicyWeights weights;
  PolicyScore score;
};

PolicyWeights drawn(const PolicyWeights& mean, const PolicyWeights& deviation, packing::Random& random) {
  PolicyWeights weights;
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] = mean[i] + deviation[i] * packing::normal(random);
  return weights;
}

void follow(const std::vector<Tried>& elite, int iteration, PolicyWeights& mean, PolicyWeights& deviation) {
  const auto n = static_cast<double>(elite.size());
  const double noise = kNoise * std::exp2(-iteration / kNoiseHalving);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (const Tried& tried : elite) sum += tried.weights[i];
    mean[i] = sum / n;
    for (const Tried& tried : elite) squares += (tried.weights[i] - mean[i]) * (tried.weights[i] - mean[i]);
    deviation[i] = (1.0 - kKept) * std::sqrt(squares / n) + kKept * deviation[i] + noise;
  }
}

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
  packing::Random random(options.seed);
  PolicyWeights mean = options.start;
  PolicyWeights deviation;
  deviation.fill(options.spread);
  const std::size_t elite =
      std::max(kLeastElite, static_cast<std::size_t>(options.elite_ratio * options.population));
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const std::vector<TuningOrder> sample = orders(iteration);
    std::vector<Tried> tried(static_cast<std::size_t>(options.population));
    tried.front().weights = mean;
    for (std::size_t i = 1; i < tried.size(); ++i) tried[i].weights = drawn(mean, deviation, random);
    packing::inParallel(tried.size(), options.threads, [&](std::size_t, std::size_t i) {
      tried[i].score = playPolicy(sample, tried[i].weights);
    });
    TuningReport now{iteration, tried.front().score, 0.0};
    std::stable_sort(tried.begin(), tried.end(),
                     [](const Tried& a, const Tried& b) { return a.score.value > b.score.value; });
    now.best_value = tried.front().score.value;
    tried.resize(std::min(tried.size(), elite));
    follow(tried, iteration, mean, deviation);
    if (report) report(now);
  }
  return mean;
}

}  // namespace mixed_palletizing::planning
