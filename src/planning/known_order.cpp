// Source: a (1+1) evolution strategy with the one-fifth rule (Rechenberg 1973) over the weights of the policy.
#include "known_order.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <mixed_palletizing/packing/random.hpp>
#include <mixed_palletizing/planning/playout.hpp>

#include "future_value.hpp"

namespace mixed_palletizing::planning {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFirstSpread = 1.0;  ///< of the weights: they are of order 1
constexpr double kLeastSpread = 0.05;
constexpr double kGrowth = 1.2;      ///< of the spread after a better play ...
constexpr double kShrinkage = 0.96;  ///< ... and after another one: they balance at one better play in five

/// Who was placed and who discarded: what is not visible when it is placed came after a discard, because a type that
/// fits is never discarded.
PlayResult retold(const packing::PalletState& pallet, const std::vector<int>& arrival, int n_pick) {
  PlayResult result;
  std::vector<int> visible;
  std::size_t next = 0;
  const auto arrive = [&] {
    while (visible.size() < static_cast<std::size_t>(n_pick) && next < arrival.size()) {
      visible.push_back(static_cast<int>(next++));
    }
  };
  const auto discard = [&] {
    result.unpacked.insert(result.unpacked.end(), visible.begin(), visible.end());
    visible.clear();
    arrive();
  };
  arrive();
  for (const packing::Placement& placement : pallet.placements()) {
    const auto isOfType = [&](int item) { return arrival[static_cast<std::size_t>(item)] == placement.type; };
    auto item = std::find_if(visible.begin(), visible.end(), isOfType);
    while (item == visible.end()) {
      discard();
      item = std::find_if(visible.begin(), visible.end(), isOfType);
    }
    result.placements.push_back({*item, placement, visible});
    visible.erase(item);
    arrive();
  }
  while (!visible.empty()) discard();
  result.utilization = pallet.utilization();
  return result;
}

PolicyWeights near(const PolicyWeights& weights, double spread, packing::Random& random) {
  PolicyWeights drawn = weights;
  for (double& weight : drawn) weight += spread * packing::normal(random);
  return drawn;
}

}  // namespace

PlayResult playKnownOrder(const packing::Order& order, const std::vector<int>& arrival,
                          const PlayOptions& options) {
  const Clock::time_point start = Clock::now();
  const auto budget =
      std::chrono::duration<double, std::milli>(options.budget_ms * static_cast<double>(arrival.size()));
  const auto over = [&](int plays) {
    return options.budget_ms > 0.0 ? Clock::now() - start >= budget : plays >= kKnownOrderPlays;
  };
  const PlayoutStart empty{packing::PalletState(order), std::vector<int>(order.types.size(), 0),
                           options.n_pick};
  PolicyWeights weights = options.planner.best.weights;
  Playout playout(order.types, order.rules, weights, options.planner.gripper);
  PlayoutEnd best = *playout.play(empty, arrival, {});
  packing::PalletState pallet = playout.pallet();
  packing::Random random(options.seed);
  double spread = kFirstSpread;
  for (int plays = 1; !best.perfect() && !over(plays); ++plays) {
    const PolicyWeights tried = near(weights, spread, random);
    playout.policy().weigh(tried);
    const PlayoutEnd end = *playout.play(empty, arrival, {});
    const double gain = futureValue(end, playout.policy().palletVolume()) -
                        futureValue(best, playout.policy().palletVolume());
    spread = std::clamp(spread * (gain > 0.0 ? kGrowth : kShrinkage), kLeastSpread, kFirstSpread);
    if (gain < 0.0) continue;
    weights = tried;
    best = end;
    pallet = playout.pallet();
  }
  PlayResult result = retold(pallet, arrival, options.n_pick);
  const auto spent = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  const std::size_t decisions = std::max<std::size_t>(result.placements.size(), 1);
  result.decision_ms.assign(decisions, spent / static_cast<double>(decisions));
  return result;
}

}  // namespace mixed_palletizing::planning
