#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/placement_rule.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

const packing::StopCallback kNever;

PlannerOptions optionsOf(PlanMethod method) {
  PlannerOptions options;
  options.method = method;
  return options;
}

/// `in_time`: every item was looked at.
void expectSound(const Situation& situation, const PlannerOptions& options, const Decision& decision, int run,
                 bool in_time = true) {
  ASSERT_EQ(decision.options.size(), situation.available.size()) << "seed 41, run " << run;
  bool any = false;
  for (std::size_t i = 0; i < decision.options.size(); ++i) {
    const PickOption& option = decision.options[i];
    if (!in_time && !option.looked_at) continue;
    const int type = situation.available[i];
    const auto corners =
        packing::cornerPlacements(situation.pallet, situation.types[static_cast<std::size_t>(type)], type);
    EXPECT_EQ(option.feasible, !corners.empty()) << "seed 41, run " << run;
    EXPECT_EQ(option.reason.empty(), option.feasible);
    any = any || option.feasible;
    if (!option.feasible) continue;
    EXPECT_EQ(option.placement.type, type);
    EXPECT_TRUE(situation.pallet.accepts(option.placement)) << "seed 41, run " << run;
    EXPECT_LE(option.future_costs.size(), static_cast<std::size_t>(options.n_cost));
    EXPECT_TRUE(std::is_sorted(option.future_costs.begin(), option.future_costs.end()));
    for (const double cost : option.future_costs) EXPECT_TRUE(cost >= 0.0 && cost <= 1.0) << cost;
  }
  EXPECT_TRUE(any || std::all_of(decision.options.begin(), decision.options.end(),
                                 [](const PickOption& option) { return option.looked_at; }))
      << "seed 41, run " << run;
  EXPECT_EQ(decision.chosen.has_value(), any);
  EXPECT_TRUE(!decision.chosen || decision.options.at(*decision.chosen).feasible);
}

TEST(ChooseNextPick, withoutTimeLooksAtTheSmallFirst) {
  const packing::Rotations yaw = packing::Rotations::yawOnly();
  packing::Order order;
  order.rules.size = {400, 300, 100};
  order.types = {
      {"tall", {200, 200, 150}, yaw}, {"wide", {300, 300, 100}, yaw}, {"small", {90, 90, 90}, yaw}};
  order.counts = {1, 1, 1};
  const packing::PalletState pallet(order);
  const Situation situation{pallet, order.types, {0, 1, 2}, order.counts};
  const Decision decision = chooseNextPick(situation, optionsOf(PlanMethod::kBest), 1, [] { return true; });
  EXPECT_EQ(decision.chosen, 2U);
  EXPECT_FALSE(decision.options.at(0).looked_at || decision.options.at(1).looked_at);
}

TEST(ChooseNextPick, isSoundOnRandomPallets) {
  std::mt19937_64 rng(41);
  for (int run = 0; run < 60; ++run) {
    const packing::Order order = test::randomOrder(rng);
    std::vector<int> items = test::shuffledItems(order, rng);
    packing::PalletState pallet(order.rules);
    std::vector<int> remaining = order.counts;
    for (int placed = test::draw(rng, 0, static_cast<int>(items.size()) - 1); placed > 0; --placed) {
      const int type = items.back();
      const auto place = packing::findPlacement(pallet, order.types[static_cast<std::size_t>(type)], type,
                                                packing::PlacementRule::kDblf);
      if (place) pallet.place(*place);
      --remaining[static_cast<std::size_t>(type)];
      items.pop_back();
    }
    items.resize(std::min<std::size_t>(items.size(), 4));
    for (const PlanMethod method : {PlanMethod::kDblf, PlanMethod::kGa, PlanMethod::kBest}) {
      const PlannerOptions options = optionsOf(method);
      const Situation situation{pallet, order.types, items, remaining};
      const Decision decision = chooseNextPick(situation, options, 7, kNever);
      expectSound(situation, options, decision, run);
      const Decision again = chooseNextPick(situation, options, 7, kNever);
      EXPECT_EQ(again.chosen, decision.chosen) << "seed 41, run " << run;
      const Decision stopped = chooseNextPick(situation, options, 7, [] { return true; });
      expectSound(situation, options, stopped, run, false);
    }
  }
}

TEST(ChooseNextPick, dblfTakesTheFirstThatFits) {
  packing::PalletState pallet(packing::PalletRules{{100, 100, 100}, 0, 1.0});
  pallet.place({0, {0, 0, 0}, {50, 100, 100}});
  const std::vector<packing::ItemType> types = {{"big", {60, 100, 50}, {}, 0, 0},
                                                {"small", {50, 50, 50}, {}, 0, 0}};
  const Situation situation{pallet, types, {0, 1, 1}, {1, 2}};
  const Decision decision = chooseNextPick(situation, optionsOf(PlanMethod::kDblf), 1, kNever);
  EXPECT_EQ(decision.chosen, std::size_t{1});
  EXPECT_NE(decision.options[0].reason.find("footprint"), std::string::npos) << decision.options[0].reason;
}

/// Whoever looks ahead must not bury the only place of the large box.
TEST(ChooseNextPick, gaSeesThatTheLargeBoxNeedsTheFloor) {
  packing::PalletState pallet(packing::PalletRules{{100, 100, 100}, 0, 1.0});
  const std::vector<packing::ItemType> types = {{"low", {100, 50, 50}, {}, 0, 0},
                                                {"tall", {50, 100, 100}, {}, 0, 0}};
  const Situation situation{pallet, types, {0, 1}, {1, 1}};
  const Decision decision = chooseNextPick(situation, optionsOf(PlanMethod::kGa), 1, kNever);
  ASSERT_TRUE(decision.chosen);
  EXPECT_EQ(*decision.chosen,
            1U);  // half a pallet tall; after it the low one fits no more, but it is smaller
  ASSERT_FALSE(decision.options[0].future_costs.empty());
  EXPECT_NEAR(decision.options[0].future_costs[0], 0.75, 1e-12);
  EXPECT_NEAR(decision.options[1].future_costs[0], 0.5, 1e-12);
}

TEST(ChooseNextPick, bestSeesThatTheLargeBoxNeedsTheFloor) {
  packing::PalletState pallet(packing::PalletRules{{100, 100, 100}, 0, 1.0});
  const std::vector<packing::ItemType> types = {{"low", {100, 50, 50}, {}, 0, 0},
                                                {"tall", {50, 100, 100}, {}, 0, 0}};
  const Situation situation{pallet, types, {0, 1}, {1, 1}};
  const Decision decision = chooseNextPick(situation, optionsOf(PlanMethod::kBest), 1, kNever);
  ASSERT_TRUE(decision.chosen);
  EXPECT_EQ(*decision.chosen, 1U);
  EXPECT_NEAR(decision.options[1].future.unpacked_ratio, 0.25, 1e-12);
  EXPECT_NEAR(decision.options[0].future.unpacked_ratio, 0.5, 1e-12);
  EXPECT_EQ(decision.options[1].future.perfect_ratio, 0.0);
}

TEST(ChooseNextPick, bestDoesNotDependOnItsThreads) {
  std::mt19937_64 rng(44);
  for (int run = 0; run < 20; ++run) {
    const packing::Order order = test::randomOrder(rng);
    std::vector<int> items = test::shuffledItems(order, rng);
    items.resize(std::min<std::size_t>(items.size(), 3));
    const packing::PalletState pallet(order.rules);
    const Situation situation{pallet, order.types, items, order.counts};
    PlannerOptions options = optionsOf(PlanMethod::kBest);
    const Decision one = chooseNextPick(situation, options, 7, kNever);
    options.best.threads = 3;
    const Decision three = chooseNextPick(situation, options, 7, kNever);
    EXPECT_EQ(one.chosen, three.chosen) << "seed 44, run " << run;
    for (std::size_t i = 0; i < items.size(); ++i) {
      EXPECT_EQ(one.options[i].placement, three.options[i].placement) << "seed 44, run " << run;
      EXPECT_EQ(one.options[i].future_costs, three.options[i].future_costs) << "seed 44, run " << run;
    }
  }
}

/// Futures in which nothing can be placed ask nobody for the time; the search must do so itself.
TEST(ChooseNextPick, bestEndsWhenNothingMoreFits) {
  packing::PalletState pallet(packing::PalletRules{{100, 100, 100}, 0, 1.0});
  const std::vector<packing::ItemType> types = {{"slab", {100, 60, 100}, {}, 0, 0},
                                                {"rest", {100, 40, 100}, {}, 0, 0},
                                                {"same", {100, 40, 100}, {}, 0, 0},
                                                {"block", {100, 50, 100}, {}, 0, 0}};
  pallet.place({0, {0, 0, 0}, {100, 60, 100}});
  for (const int blocks : {0, 7}) {
    const Situation situation{pallet, types, {1, 2, 0}, {5, 1, 1, blocks}};
    int asked = 0;
    const Decision decision =
        chooseNextPick(situation, optionsOf(PlanMethod::kBest), 1, [&] { return ++asked > 100000; });
    ASSERT_TRUE(decision.chosen);
    EXPECT_LT(*decision.chosen, 2U);
  }
}

TEST(ChooseNextPick, theLastItemsAreExact) {
  std::mt19937_64 rng(43);
  for (int run = 0; run < 40; ++run) {
    packing::Order order = test::randomOrder(rng);
    std::fill(order.counts.begin(), order.counts.end(), 1);
    order.counts.resize(std::min<std::size_t>(order.counts.size(), 4));
    order.types.resize(order.counts.size());
    const packing::PalletState pallet(order.rules);
    std::vector<int> available;
    for (std::size_t i = 0; i < order.types.size(); ++i) available.push_back(static_cast<int>(i));
    const Situation situation{pallet, order.types, available, order.counts};
    const Decision decision = chooseNextPick(situation, optionsOf(PlanMethod::kGa), 1, kNever);
    for (std::size_t i = 0; i < available.size(); ++i) {
      if (decision.options[i].future_costs.empty()) continue;
      std::vector<int> rest = available;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      double best = 0.0;
      do {
        std::vector<int> sequence{available[i]};
        sequence.insert(sequence.end(), rest.begin(), rest.end());
        best = std::max(
            best,
            packing::packSequence(pallet, order.types, sequence, packing::PlacementRule::kDblf).utilization);
      } while (std::next_permutation(rest.begin(), rest.end()));
      EXPECT_NEAR(decision.options[i].future_costs[0], 1.0 - best, 1e-12) << "seed 43, run " << run;
    }
  }
}

TEST(ChooseNextPick, equalItemsAreJudgedOnce) {
  const packing::PalletState pallet(packing::PalletRules{{400, 400, 400}, 0, 1.0});
  const std::vector<packing::ItemType> types = {{"a", {70, 90, 60}, {}, 0, 0},
                                                {"b", {130, 50, 80}, {}, 0, 0}};
  const Situation situation{pallet, types, {0, 1, 0, 0, 1}, {20, 20}};
  const Decision decision = chooseNextPick(situation, optionsOf(PlanMethod::kGa), 3, kNever);
  EXPECT_EQ(decision.options[0].future_costs, decision.options[2].future_costs);
  EXPECT_EQ(decision.options[1].future_costs, decision.options[4].future_costs);
  EXPECT_LT(*decision.chosen, 2U);
}

TEST(ChooseNextPick, takesTenThousandBoxes) {
  const packing::PalletState pallet(packing::PalletRules{{1200, 800, 600}, 0, 1.0});
  const std::vector<packing::ItemType> types = {{"a", {100, 100, 100}, {}, 0, 0}};
  const Situation situation{pallet, types, std::vector<int>(10000, 0), {10000}};
  EXPECT_EQ(chooseNextPick(situation, optionsOf(PlanMethod::kGa), 1, kNever).chosen, std::size_t{0});
  EXPECT_EQ(chooseNextPick(situation, optionsOf(PlanMethod::kBest), 1, kNever).chosen, std::size_t{0});
  const Situation nothing{pallet, types, {}, {0}};
  EXPECT_FALSE(chooseNextPick(nothing, optionsOf(PlanMethod::kGa), 1, kNever).chosen);
}

TEST(ChooseNextPick, refusesBadInput) {
  const packing::PalletState pallet(packing::PalletRules{{100, 100, 100}, 0, 1.0});
  const std::vector<packing::ItemType> types = {{"a", {50, 50, 50}, {}, 0, 0}};
  const auto refused = [&](std::vector<int> available, std::vector<int> remaining) {
    const Situation situation{pallet, types, std::move(available), std::move(remaining)};
    EXPECT_THROW(chooseNextPick(situation, PlannerOptions(), 1, kNever), std::invalid_argument);
  };
  refused({0, 0}, {1});
  refused({1}, {1});
  refused({-1}, {1});
  refused({0}, {1, 1});
  refused({0}, {});
  for (const std::vector<double>& forecast : {std::vector<double>{1.0, 1.0}, {-1.0}, {std::nan("")}}) {
    const Situation foretold{pallet, types, {0}, {1}, forecast};
    EXPECT_THROW(chooseNextPick(foretold, PlannerOptions(), 1, kNever), std::invalid_argument);
  }
  PlannerOptions options;
  options.n_cost = 0;
  EXPECT_EQ(problems(options).size(), 1U);
  options.best.samples = -1;
  options.best.weights[0] = std::nan("");
  EXPECT_EQ(problems(options).size(), 3U);
  options.genetic.population = 0;
  EXPECT_GT(problems(options).size(), 1U);
  const Situation situation{pallet, types, {0}, {1}};
  EXPECT_THROW(chooseNextPick(situation, options, 1, kNever), std::invalid_argument);
  EXPECT_FALSE(planMethodFromString("DBLF"));
}

}  // namespace
}  // namespace mixed_palletizing::planning
