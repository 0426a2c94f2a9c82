// The cross-entropy method as in policy_tuning, on sampled futures of one order instead of on many orders.
#include "order_policy.hpp"

#include <atomic>
#include <cmath>
#include <numeric>

#include <mixed_palletizing/packing/in_parallel.hpp>

#include "future_value.hpp"

namespace mixed_palletizing::planning {
namespace {

constexpr double kNoise = 0.1;
constexpr std::size_t kPopulation = 16;
constexpr std::size_t kElite = 4;
constexpr std::size_t kFuturesOfGeneration = 12;
constexpr std::size_t kFuturesToCompare = 48;
/// Futures of the search and those of the race must not be the same: the weights would fit them.
constexpr std::size_t kFirstFuture = 1U << 24U;
constexpr double kStandardErrorsAhead = 1.0;

}  // namespace

OrderPolicy::OrderPolicy(const PlayoutStart& start, const SampledFutures& futures,
                         std::vector<Playout>& engines, const PolicyWeights& weights, double spread,
                         std::uint64_t seed)
    : start_(start),
      futures_(futures),
      engines_(engines),
      search_(weights, spread, kNoise, seed),
      next_future_(kFirstFuture),
      futures_of_generation_(futures.onlyOne() ? 1 : kFuturesOfGeneration),
      futures_to_compare_(futures.onlyOne() ? 1 : kFuturesToCompare) {}

bool OrderPolicy::search(std::size_t plays, const packing::StopCallback& stop) {
  for (std::size_t done = 0; done < plays; done += kPopulation * futures_of_generation_) {
    const std::vector<PolicyWeights> drawn = search_.draw(kPopulation);
    std::vector<double> values;
    if (!play(drawn, next_future_, futures_of_generation_, stop, values)) return false;
    next_future_ += futures_of_generation_;
    std::vector<TriedWeights> tried;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * futures_of_generation_);
      tried.push_back(
          {drawn[i],
           std::accumulate(first, first + static_cast<std::ptrdiff_t>(futures_of_generation_), 0.0)});
    }
    search_.follow(std::move(tried), kElite);
  }
  return true;
}

bool OrderPolicy::better(const PolicyWeights& weights, const PolicyWeights& others,
                         const packing::StopCallback& stop) {
  std::vector<double> values;
  if (!play({weights, others}, next_future_, futures_to_compare_, stop, values)) return false;
  next_future_ += futures_to_compare_;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < futures_to_compare_; ++i) {
    const double gain = values[i] - values[futures_to_compare_ + i];
    sum += gain;
    squares += gain * gain;
  }
  const auto n = static_cast<double>(futures_to_compare_);
  const double mean = sum / n;
  return mean > kStandardErrorsAhead * std::sqrt(std::max(0.0, squares / n - mean * mean) / n);
}

/// Each of the weights plays the same futures; their values follow each other.
bool OrderPolicy::play(const std::vector<PolicyWeights>& weights, std::size_t first_future, std::size_t count,
                       const packing::StopCallback& stop, std::vector<double>& values) {
  std::vector<std::vector<int>> arrivals;
  for (std::size_t i = 0; i < count; ++i) {
    if (stop && stop()) return false;  // of many boxes each draw takes its time
    arrivals.push_back(futures_.arrival(first_future + i));
  }
  values.assign(weights.size() * count, 0.0);
  std::atomic<bool> stopped{false};
  packing::inParallel(values.size(), static_cast<int>(engines_.size()),
                      [&](std::size_t worker, std::size_t i) {
                        if (stopped) return;
                        Playout& engine = engines_[worker];
                        engine.policy().weigh(weights[i / count]);
                        const auto end = engine.play(start_, arrivals[i % count], stop);
                        if (end) {
                          values[i] = futureValue(*end, engine.policy().palletVolume());
                        } else {
                          stopped = true;
                        }
                      });
  return !stopped;
}

}  // namespace mixed_palletizing::planning
