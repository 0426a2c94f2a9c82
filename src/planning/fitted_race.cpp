#include "fitted_race.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "candidates.hpp"

namespace mixed_palletizing::planning {
namespace {

/// Rounds after which it is seen whether futures become perfect.
constexpr int kFirstRounds = 24;
/// Rounds at least of the leader of a heat that takes the place of the one before.
constexpr std::size_t kLeastRounds = 16;
/// The policy is fitted where at most this share of the leader's futures leaves nothing over.
constexpr double kHardlyPerfectRatio = 0.125;
/// A single future is known by heart after so many.
constexpr std::size_t kMostPlaysOfOneFuture = 2048;
/// Of every pair that is looked at.
constexpr std::size_t kLeastFutures = 4;
/// Of the weights when the fit begins, which are of order 1 ...
constexpr double kFirstSpread = 0.7;
/// ... and when it goes on from what the decision before found.
constexpr double kNextSpread = 0.35;

}  // namespace

FittedRace::FittedRace(const Situation& situation, const std::vector<int>& types,
                       const PlannerOptions& options, std::uint64_t seed, const packing::StopCallback& stop)
    : situation_(situation),
      types_(types),
      options_(options),
      seed_(seed),
      stop_(stop),
      futures_(situation, seed) {
  for (int i = 0; i < options.best.threads; ++i) {
    engines_.emplace_back(situation.types, situation.pallet.rules(), options.best.weights, options.gripper);
  }
  heat_ = heatWith(options.best.fitted.value_or(options.best.weights));
}

std::unique_ptr<FittedRace::Heat> FittedRace::heatWith(const PolicyWeights& weights) {
  auto heat = std::make_unique<Heat>();
  heat->weights = weights;
  engines_.front().policy().weigh(weights);
  heat->pairs = scoredPlacements(situation_.pallet, types_, withExpected(situation_).remaining,
                                 options_.gripper, engines_.front().policy(), stop_);
  if (!heat->pairs.empty()) {
    // With no time left the best rated pair is the choice: no others need to be set up.
    const int lanes = stop_ && stop_() ? 1 : options_.best.candidates;
    heat->race.emplace(situation_, heat->pairs, lanes, engines_, futures_);
  }
  return heat;
}

void FittedRace::runHeat(Heat& heat, std::optional<int> samples) {
  for (Playout& engine : engines_) engine.policy().weigh(heat.weights);
  heat.race->run(samples, stop_);
}

void FittedRace::run(std::optional<int> samples) {
  if (heat_->pairs.size() < 2 || options_.best.candidates < 2) return;
  if (samples) return runHeat(*heat_, samples);
  runHeat(*heat_, kFirstRounds);
  if (hardlyPerfect()) fit();
  if (!stop_()) runHeat(*heat_, std::nullopt);
}

bool FittedRace::hardlyPerfect() const {
  const std::vector<PlayoutEnd>& ends = heat_->race->runners()[heat_->race->leader()].ends;
  const auto perfect = std::count_if(ends.begin(), ends.end(), [](const auto& end) { return end.perfect(); });
  return static_cast<double>(perfect) <= kHardlyPerfectRatio * static_cast<double>(ends.size());
}

/// Looks at more pairs and fits in turn, each turn twice as long as the one before.
void FittedRace::fit() {
  const PlayoutStart start = playoutStart(situation_);
  const double spread = options_.best.fitted ? kNextSpread : kFirstSpread;
  OrderPolicy policy(start, futures_, engines_, heat_->weights, spread, seed_);
  std::size_t plays = kFirstRounds * static_cast<std::size_t>(options_.best.candidates);
  const std::size_t most =
      futures_.onlyOne() ? kMostPlaysOfOneFuture : std::numeric_limits<std::size_t>::max();
  for (; plays <= most && !stop_() && hardlyPerfect(); plays *= 2) {
    lookAround(*heat_, plays);
    if (!policy.search(plays, stop_)) return;
    if (policy.better(policy.weights(), heat_->weights, stop_)) adopt(policy.weights(), plays);
  }
}

/// With about so many plays.
void FittedRace::lookAround(Heat& heat, std::size_t plays) {
  if (futures_.onlyOne()) return runHeat(heat, std::nullopt);
  for (Playout& engine : engines_) engine.policy().weigh(heat.weights);
  const std::size_t pairs = std::min(heat.pairs.size(), plays / (2 * kLeastFutures));
  heat.race->halve(pairs, std::max(kLeastFutures, plays / (2 * pairs)), stop_);
}

void FittedRace::adopt(const PolicyWeights& weights, std::size_t plays) {
  std::unique_ptr<Heat> next = heatWith(weights);
  if (!next->race || stop_()) return;
  lookAround(*next, plays);
  const PlayoutRace& race = *next->race;
  const std::size_t played = race.runners()[race.leader()].ends.size();
  if (played >= (futures_.onlyOne() ? 1 : kLeastRounds)) heat_ = std::move(next);
}

}  // namespace mixed_palletizing::planning
