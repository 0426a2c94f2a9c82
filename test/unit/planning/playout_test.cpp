#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/instances/generator.hpp>
#include <mixed_palletizing/planning/playout.hpp>
#include <mixed_palletizing/planning/policy_tuning.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

PlayoutStart beginning(const packing::Order& order, int n_pick) {
  return {packing::PalletState(order), std::vector<int>(order.types.size(), 0), n_pick};
}

TEST(Playout, everythingIsPackedOrLeftOver) {
  std::mt19937_64 rng(81);
  for (int run = 0; run < 40; ++run) {
    const packing::Order order = test::randomOrder(rng);
    const std::vector<int> items = test::shuffledItems(order, rng);
    Playout playout(order.types, order.rules, tunedPolicyWeights());
    const PlayoutStart start = beginning(order, test::draw(rng, 1, 10));
    const auto end = playout.play(start, items, {});
    ASSERT_TRUE(end);
    const double packed = end->utilization * static_cast<double>(packing::volume(order.rules.size));
    EXPECT_NEAR(packed + end->unpacked_volume, static_cast<double>(order.itemVolume()), 1.0)
        << "seed 81, run " << run;
    EXPECT_EQ(end->perfect(), end->unpacked_volume == 0.0) << "seed 81, run " << run;
    const auto again = playout.play(start, items, {});
    EXPECT_EQ(again->utilization, end->utilization) << "seed 81, run " << run;
    EXPECT_FALSE(playout.play(start, items, [] { return true; })) << "seed 81, run " << run;
  }
}

TEST(Playout, whatFitsNowhereIsDiscardedInOneGo) {
  packing::Order order;
  order.rules.size = {100, 100, 100};
  order.types = {{"full", {100, 100, 60}, {}, 0, 0}, {"flat", {100, 100, 40}, {}, 0, 0}};
  order.counts = {3, 1};
  Playout playout(order.types, order.rules, tunedPolicyWeights());
  // The first full one is placed, two that fit no more are discarded together, then the flat one arrives.
  const auto end = playout.play(beginning(order, 2), {0, 0, 0, 1}, {});
  ASSERT_TRUE(end);
  EXPECT_EQ(end->unpacked, 2);
  EXPECT_DOUBLE_EQ(end->utilization, 1.0);
}

std::vector<TuningOrder> orders(int iteration) {
  std::vector<TuningOrder> made;
  for (int i = 0; i < 4; ++i) {
    const instances::Instance instance = instances::generateInstance({}, 82, 4 * iteration + i);
    made.push_back({instance.order, instance.arrival, instance.n_pick});
  }
  return made;
}

TEST(TunePolicy, improvesNoWeightsAtAll) {
  TuningOptions options;
  options.iterations = 6;
  options.population = 12;
  int reports = 0;
  const PolicyWeights tuned = tunePolicy(options, orders, [&](const TuningReport& report) {
    EXPECT_EQ(report.iteration, reports++);
    EXPECT_GE(report.best_value, report.mean.value);
  });
  EXPECT_EQ(reports, options.iterations);
  std::vector<TuningOrder> unseen;
  for (int i = 1000; i < 1010; ++i) {
    for (TuningOrder& order : orders(i)) unseen.push_back(std::move(order));
  }
  EXPECT_GT(playPolicy(unseen, tuned).value, playPolicy(unseen, {}).value);
  options.threads = 2;
  EXPECT_EQ(tunePolicy(options, orders), tuned);
}

TEST(TunePolicy, refusesBadOptions) {
  TuningOptions options;
  options.iterations = 0;
  options.population = 1;
  options.elite_ratio = 0.0;
  options.spread = -1.0;
  options.threads = 0;
  EXPECT_EQ(problems(options).size(), 5U);
  EXPECT_THROW(tunePolicy(options, orders), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::planning
