#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/key_genetic_search.hpp>

#include "../../../src/packing/scored_rules.hpp"
#include "random_play.hpp"

namespace mixed_palletizing::packing {
namespace {

using test::draw;

struct Task {
  Order order;
  std::vector<int> items;
};

Task randomTask(std::mt19937_64& rng) {
  Task task;
  task.order.rules.size = {draw(rng, 12, 20), draw(rng, 12, 20), draw(rng, 12, 20)};
  if (rng() % 3 == 0) task.order.rules.min_support_ratio = 0.6;
  const Rotations kinds[] = {Rotations::none(), Rotations::yawOnly(), Rotations::any()};
  for (int t = 0; t < 4; ++t) {
    task.order.types.push_back({"", {draw(rng, 2, 9), draw(rng, 2, 9), draw(rng, 2, 9)}, kinds[rng() % 3]});
    for (int n = draw(rng, 1, 5); n > 0; --n) task.items.push_back(t);
  }
  return task;
}

KeyGeneticOptions fewGenerations(std::uint64_t seed) {
  KeyGeneticOptions options;
  options.population = 12;
  options.generations = 4;
  options.seed = seed;
  return options;
}

TEST(KeyGeneticSearch, packsSoundlyAndTheSameWithAnyNumberOfThreads) {
  std::mt19937_64 rng(5);
  for (int round = 0; round < 40; ++round) {
    const Task task = randomTask(rng);
    const PalletState start(task.order);
    KeyGeneticOptions options = fewGenerations(rng());
    std::vector<double> best;
    const SequenceResult found =
        keyGeneticSearch(start, task.order.types, task.items, options, {},
                         [&](const GenerationReport& r) { best.push_back(r.best_utilization); });
    EXPECT_TRUE(std::is_sorted(best.begin(), best.end())) << "the elite goes on";
    PalletState pallet(task.order);
    for (const Placement& p : found.placements) {
      ASSERT_EQ(pallet.whyNot(p), "") << "seed 5, round " << round;
      pallet.place(p);
    }
    EXPECT_DOUBLE_EQ(pallet.utilization(), found.utilization);
    EXPECT_EQ(found.placements.size() + found.unpacked.size(), task.items.size());
    std::vector<int> sequence = found.sequence;
    std::sort(sequence.begin(), sequence.end());
    EXPECT_EQ(sequence, task.items);
    options.threads = 3;
    EXPECT_TRUE(keyGeneticSearch(start, task.order.types, task.items, options, {}).placements ==
                found.placements);
    int asked = 0;
    const auto stop = [&asked] { return ++asked > 7; };
    const SequenceResult early = keyGeneticSearch(start, task.order.types, task.items, options, stop);
    EXPECT_LE(early.utilization, found.utilization + 1e-12) << "never better than what goes on from it";
  }
}

TEST(KeyGeneticSearch, refusesBadOptions) {
  Task task;
  task.order.rules.size = {10, 10, 10};
  task.order.types.push_back({"A", {5, 5, 5}, {}});
  task.items.push_back(0);
  const PalletState start(task.order);
  const auto search = [&](const KeyGeneticOptions& options) {
    return keyGeneticSearch(start, task.order.types, task.items, options, {});
  };
  EXPECT_THROW(search({}), std::invalid_argument) << "would never end";
  for (int broken = 0; broken < 6; ++broken) {
    KeyGeneticOptions options = fewGenerations(1);
    if (broken == 0) options.population = 0;
    if (broken == 1) options.generations = -1;
    if (broken == 2) options.threads = 0;
    if (broken == 3) options.elite_share = 1.5;
    if (broken == 4) options.mutant_share = -0.1;
    if (broken == 5) options.prob_elite = 2.0;
    EXPECT_THROW(search(options), std::invalid_argument) << broken;
  }
  EXPECT_THROW(keyGeneticSearch(start, task.order.types, {1}, fewGenerations(1), {}), std::invalid_argument);
  EXPECT_TRUE(keyGeneticSearch(start, task.order.types, {}, fewGenerations(1), {}).placements.empty());
}

TEST(ScoredRules, choosePlacesByTheirScores) {
  std::mt19937_64 rng(6);
  for (int round = 0; round < 300; ++round) {
    PalletRules rules{{draw(rng, 8, 14), draw(rng, 8, 14), draw(rng, 6, 10)}};
    if (rng() % 3 == 0) rules.min_support_ratio = 0.7;
    const PalletState state = test::randomPallet(rules, rng, draw(rng, 0, 8), 5);
    const ItemType type{"", {draw(rng, 1, 5), draw(rng, 1, 5), draw(rng, 1, 5)}, Rotations::any()};
    const auto contact = findPlacement(state, type, 0, PlacementRule::kContact);
    const auto fitting = findPlacement(state, type, 0, PlacementRule::kBestFit);
    const auto deepest = findPlacement(state, type, 0, PlacementRule::kDblf);
    ASSERT_EQ(contact.has_value(), deepest.has_value()) << "seed 6, round " << round;
    ASSERT_EQ(fitting.has_value(), deepest.has_value());
    if (!contact) continue;
    EXPECT_EQ(state.whyNot(*contact), "");
    EXPECT_EQ(state.whyNot(*fitting), "");
    EXPECT_GE(touchingShare(state, *contact), touchingShare(state, *deepest) - 1e-12);
  }
}

TEST(ScoredRules, countsWhatTouches) {
  PalletState state(PalletRules{{100, 100, 100}});
  state.place({0, {0, 0, 0}, {50, 50, 40}});
  EXPECT_DOUBLE_EQ(touchingShare(state, {0, {50, 0, 0}, {50, 50, 40}}), 0.75)
      << "two sides of the pallet, one box";
  EXPECT_DOUBLE_EQ(touchingShare(state, {0, {50, 0, 0}, {50, 50, 80}}), 0.625);
  EXPECT_DOUBLE_EQ(touchingShare(state, {0, {60, 60, 0}, {20, 20, 40}}), 0.0);
  EXPECT_EQ(findPlacement(state, std::vector<Vec3>{{50, 50, 40}}, 1, PlacementRule::kContact)->origin,
            (Vec3{50, 0, 0}));
  EXPECT_EQ(findPlacement(state, std::vector<Vec3>{{50, 50, 60}}, 1, PlacementRule::kBestFit)->origin,
            (Vec3{0, 0, 40}));
}

}  // namespace
}  // namespace mixed_palletizing::packing
