#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/instances/generator.hpp>
#include <mixed_palletizing/instances/packing_result.hpp>
#include <mixed_palletizing/planning/play_arrivals.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

/// What the independent check finds in a play.
std::vector<std::string> faultsOf(const instances::Instance& instance, const PlayResult& play) {
  instances::PackingResult result;
  result.name = instance.name;
  result.utilization = play.utilization;
  result.unpacked = play.unpacked;
  for (const PlayedPlacement& p : play.placements)
    result.placements.push_back({p.item, p.placement, p.available});
  return instances::checkResult(instance, result);
}

instances::Instance randomInstance(std::mt19937_64& rng) {
  instances::Instance instance;
  instance.name = "random";
  instance.order = test::randomOrder(rng);
  instance.arrival = test::shuffledItems(instance.order, rng);
  instance.n_pick = test::draw(rng, 1, 5);
  return instance;
}

TEST(PlayArrivals, keepsEveryRuleOnRandomOrders) {
  std::mt19937_64 rng(51);
  for (int run = 0; run < 60; ++run) {
    const instances::Instance instance = randomInstance(rng);
    PlayOptions options;
    options.n_pick = instance.n_pick;
    options.planner.method =
        run % 3 == 0 ? PlanMethod::kDblf : (run % 3 == 1 ? PlanMethod::kGa : PlanMethod::kBest);
    options.planner.best.samples = 2;
    int last = 0;
    const PlayResult play = playArrivals(instance.order, instance.arrival, options, [&](int done, int total) {
      EXPECT_GT(done, last);
      EXPECT_LE(done, total);
      last = done;
    });
    EXPECT_EQ(last, static_cast<int>(instance.arrival.size()));
    const auto faults = faultsOf(instance, play);
    EXPECT_TRUE(faults.empty()) << "seed 51, run " << run << ": " << faults.front();
    EXPECT_EQ(playArrivals(instance.order, instance.arrival, options).unpacked, play.unpacked);
  }
}

TEST(PlayArrivals, gaLeavesLessThanDblfAndBestLessThanGa) {
  std::size_t best = 0;
  std::size_t ga = 0;
  std::size_t dblf = 0;
  for (int i = 0; i < 25; ++i) {
    const instances::Instance instance = instances::generateInstance({}, 61, i);
    PlayOptions options;
    options.planner.best.samples = 4;
    const PlayResult by_best = playArrivals(instance.order, instance.arrival, options);
    options.planner.method = PlanMethod::kGa;
    const PlayResult by_ga = playArrivals(instance.order, instance.arrival, options);
    options.planner.method = PlanMethod::kDblf;
    const PlayResult by_dblf = playArrivals(instance.order, instance.arrival, options);
    EXPECT_TRUE(faultsOf(instance, by_best).empty()) << "seed 61, index " << i;
    best += by_best.unpacked.size();
    EXPECT_TRUE(faultsOf(instance, by_ga).empty()) << "seed 61, index " << i;
    EXPECT_TRUE(faultsOf(instance, by_dblf).empty()) << "seed 61, index " << i;
    ga += by_ga.unpacked.size();
    dblf += by_dblf.unpacked.size();
  }
  EXPECT_LT(ga, dblf);
  EXPECT_LT(best, ga);
}

TEST(PlayArrivals, knowingLessThanTheSetKeepsTheRules) {
  for (int i = 0; i < 8; ++i) {
    const instances::Instance instance = instances::generateInstance({}, 63, i);
    PlayOptions options;
    options.knowledge = i % 2 == 0 ? PlayKnowledge::kTypes : PlayKnowledge::kForecast;
    options.planner.best.samples = 4;
    options.planner.method = i < 2 ? PlanMethod::kGa : PlanMethod::kBest;
    const PlayResult play = playArrivals(instance.order, instance.arrival, options);
    EXPECT_TRUE(faultsOf(instance, play).empty()) << "seed 63, index " << i;
    EXPECT_GT(play.utilization, 0.5) << "seed 63, index " << i;
  }
}

TEST(PlayArrivals, whoKnowsTheOrderKeepsTheRulesAndLeavesNoMore) {
  std::mt19937_64 rng(64);
  double known = 0.0;
  double policy = 0.0;
  for (int run = 0; run < 24; ++run) {
    const instances::Instance instance = randomInstance(rng);
    PlayOptions options;
    options.n_pick = instance.n_pick;
    options.knowledge = PlayKnowledge::kOrder;
    const PlayResult play = playArrivals(instance.order, instance.arrival, options);
    const auto faults = faultsOf(instance, play);
    EXPECT_TRUE(faults.empty()) << "seed 64, run " << run << ": " << faults.front();
    EXPECT_EQ(play.placements.size() + play.unpacked.size(), instance.arrival.size())
        << "seed 64, run " << run;
    EXPECT_EQ(playArrivals(instance.order, instance.arrival, options).unpacked, play.unpacked);
    known += play.utilization;
    options.knowledge = PlayKnowledge::kSet;
    options.planner.best.candidates = 1;  // the policy alone
    policy += playArrivals(instance.order, instance.arrival, options).utilization;
  }
  EXPECT_GE(known, policy) << "seed 64";
}

TEST(PlayArrivals, aTinyBudgetStillPlaysToTheEnd) {
  const instances::Instance instance = instances::generateInstance({}, 62, 0);
  PlayOptions options;
  options.budget_ms = 1e-6;
  EXPECT_TRUE(faultsOf(instance, playArrivals(instance.order, instance.arrival, options)).empty());
}

TEST(PlayArrivals, refusesBadInput) {
  const instances::Instance instance = instances::generateInstance({}, 62, 0);
  PlayOptions options;
  options.n_pick = 0;
  options.budget_ms = std::numeric_limits<double>::quiet_NaN();
  options.planner.method = PlanMethod::kGa;
  options.knowledge = PlayKnowledge::kOrder;  // of use for kBest only
  EXPECT_EQ(problems(options).size(), 3U);
  EXPECT_FALSE(playKnowledgeFromString("all"));
  EXPECT_EQ(playKnowledgeFromString("forecast"), PlayKnowledge::kForecast);
  EXPECT_THROW(playArrivals(instance.order, instance.arrival, options), std::invalid_argument);
  std::vector<int> arrival = instance.arrival;
  arrival.pop_back();
  EXPECT_THROW(playArrivals(instance.order, arrival, {}), std::invalid_argument);
  arrival.push_back(100);
  EXPECT_THROW(playArrivals(instance.order, arrival, {}), std::invalid_argument);
  packing::Order order = instance.order;
  order.types[0].size.x = -1;
  EXPECT_THROW(playArrivals(order, instance.arrival, {}), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::planning
