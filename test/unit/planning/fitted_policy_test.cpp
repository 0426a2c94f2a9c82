#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include <mixed_palletizing/instances/generator.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>
#include <mixed_palletizing/planning/playout.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

constexpr std::uint64_t kSeed = 83;
constexpr int kStopCalls = 400000;  ///< several rounds of fitting

instances::Instance orderOf(int index, int size_spread) {
  instances::GeneratorOptions options;
  options.pallet.z = 400;
  options.size_spread = size_spread;
  return instances::generateInstance(options, kSeed, index);
}

Situation startOf(const instances::Instance& instance, const packing::PalletState& pallet) {
  return {pallet, instance.order.types,
          std::vector<int>(instance.arrival.begin(), instance.arrival.begin() + instance.n_pick),
          instance.order.counts};
}

/// Counts instead of looking at a clock, so that a run is the same again.
packing::StopCallback after(int calls) {
  return [left = std::make_shared<int>(calls)] { return --*left < 0; };
}

/// Mean utilization over random arrivals.
double played(const instances::Instance& instance, const PolicyWeights& weights) {
  std::mt19937_64 rng(kSeed);
  Playout playout(instance.order.types, instance.order.rules, weights);
  const PlayoutStart start{packing::PalletState(instance.order),
                           std::vector<int>(instance.order.types.size(), 0), instance.n_pick};
  double sum = 0.0;
  constexpr int kPlays = 100;
  for (int i = 0; i < kPlays; ++i) {
    sum += playout.play(start, test::shuffledItems(instance.order, rng), {})->utilization;
  }
  return sum / kPlays;
}

TEST(FittedPolicy, playsOrdersThatLeaveMuchOverBetter) {
  double gain = 0.0;
  for (int i = 0; i < 4; ++i) {
    const instances::Instance instance = orderOf(i, 10);
    const packing::PalletState pallet(instance.order);
    const Decision decision =
        chooseNextPick(startOf(instance, pallet), PlannerOptions(), kSeed, after(kStopCalls));
    ASSERT_TRUE(decision.chosen) << "seed " << kSeed << ", order " << i;
    if (!decision.fitted) continue;
    gain += played(instance, *decision.fitted) - played(instance, tunedPolicyWeights());
  }
  EXPECT_GT(gain, 0.0) << "seed " << kSeed;
}

TEST(FittedPolicy, isLeftAloneWhereOrdersBecomePerfect) {
  const packing::ItemType quarter{"quarter", {400, 300, 100}, {}, 0, 0};
  packing::Order order;
  order.rules.size = {800, 600, 200};
  order.types = {quarter, {"half", {800, 300, 100}, {}, 0, 0}};
  order.counts = {4, 2};
  const packing::PalletState pallet(order);
  const Situation situation{pallet, order.types, {0, 1, 0}, order.counts};
  EXPECT_FALSE(chooseNextPick(situation, PlannerOptions(), kSeed, after(kStopCalls)).fitted);
}

TEST(FittedPolicy, decisionsAreSoundHoweverEarlyTheyAreCut) {
  const instances::Instance instance = orderOf(7, 10);
  const packing::PalletState pallet(instance.order);
  PlannerOptions options;
  for (int calls = 0; calls < kStopCalls; calls = 3 * calls + 1) {
    const Situation situation = startOf(instance, pallet);
    const Decision decision = chooseNextPick(situation, options, kSeed, after(calls));
    ASSERT_TRUE(decision.chosen) << "seed " << kSeed << ", calls " << calls;
    const PickOption& option = decision.options.at(*decision.chosen);
    EXPECT_TRUE(pallet.accepts(option.placement)) << "seed " << kSeed << ", calls " << calls;
    EXPECT_EQ(option.placement.type, situation.available.at(*decision.chosen));
    if (decision.fitted) options.best.fitted = decision.fitted;
  }
}

TEST(FittedPolicy, refusesWeightsThatAreNoNumbers) {
  BestOptions options;
  options.fitted = tunedPolicyWeights();
  EXPECT_TRUE(problems(options).empty());
  options.fitted->front() = std::nan("");
  EXPECT_EQ(problems(options).size(), 1U);
}

}  // namespace
}  // namespace mixed_palletizing::planning
