#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/genetic_search.hpp>

#include "random_play.hpp"

namespace mixed_palletizing::packing {
namespace {

using test::draw;

struct Case {
  PalletState state{PalletRules{{1, 1, 1}}};
  std::vector<ItemType> types;
  std::vector<int> items;
};

Case randomCase(std::mt19937_64& rng) {
  Case c;
  const PalletRules rules{{draw(rng, 6, 12), draw(rng, 6, 12), draw(rng, 6, 12)}};
  c.state = test::randomPallet(rules, rng, draw(rng, 0, 3), 3);
  for (int t = draw(rng, 1, 6); t > 0; --t) {
    c.types.push_back({"", {draw(rng, 1, 7), draw(rng, 1, 7), draw(rng, 1, 7)}, {}});
  }
  for (int i = draw(rng, 0, 25); i > 0; --i)
    c.items.push_back(draw(rng, 0, static_cast<int>(c.types.size()) - 1));
  return c;
}

/// Every placement is valid where it is made, the unpacked ones fit nowhere, and the utilization is true.
void expectSound(const Case& c, const SequenceResult& result) {
  PalletState state = c.state;
  std::size_t next = 0;
  for (std::size_t i = 0; i < result.sequence.size(); ++i) {
    if (std::count(result.unpacked.begin(), result.unpacked.end(), static_cast<int>(i)) > 0) continue;
    ASSERT_LT(next, result.placements.size());
    const Placement& p = result.placements[next++];
    ASSERT_EQ(p.type, result.sequence[i]);
    ASSERT_EQ(state.whyNot(p), "");
    state.place(p);
  }
  EXPECT_EQ(next, result.placements.size());
  EXPECT_DOUBLE_EQ(result.utilization, state.utilization());
}

TEST(PackSequence, placesByTheRuleAndLeavesOutWhatFitsNowhere) {
  std::mt19937_64 rng(1);
  for (int round = 0; round < 500; ++round) {
    const Case c = randomCase(rng);
    const PlacementRule rule = round % 2 == 0 ? PlacementRule::kDblf : PlacementRule::kDistance;
    const SequenceResult result = packSequence(c.state, c.types, c.items, rule);
    expectSound(c, result);
    PalletState state = c.state;
    std::vector<int> unpacked;
    for (std::size_t i = 0; i < c.items.size(); ++i) {
      const int type = c.items[i];
      const auto p = findPlacement(state, c.types[static_cast<std::size_t>(type)], type, rule);
      p ? state.place(*p) : unpacked.push_back(static_cast<int>(i));
    }
    ASSERT_EQ(result.unpacked, unpacked) << "seed 1, round " << round;
  }
  EXPECT_THROW(packSequence(PalletState(PalletRules{{1, 1, 1}}), {}, {0}, PlacementRule::kDblf),
               std::invalid_argument);
  EXPECT_THROW(packSequence(PalletState(PalletRules{{1, 1, 1}}), {}, {-1}, PlacementRule::kDblf),
               std::invalid_argument);
}

TEST(GeneticSearch, isSoundRepeatableAndKeepsTheItems) {
  std::mt19937_64 rng(2);
  for (int round = 0; round < 150; ++round) {
    const Case c = randomCase(rng);
    GeneticOptions options;
    options.seed = static_cast<std::uint64_t>(round);
    options.population = draw(rng, 1, 9);
    options.elite = draw(rng, 0, std::min(options.population, 3));
    std::vector<double> reported;
    const auto report = [&](const GenerationReport& r) { reported.push_back(r.best_utilization); };
    const GeneticResult result = geneticSearch(c.state, c.types, c.items, options, 5, {}, report);
    expectSound(c, result.best);
    EXPECT_TRUE(std::is_permutation(c.items.begin(), c.items.end(), result.best.sequence.begin(),
                                    result.best.sequence.end()));
    ASSERT_FALSE(result.best_utilizations.empty());
    EXPECT_LE(result.best_utilizations.size(), 5U);
    EXPECT_DOUBLE_EQ(result.best_utilizations.front(), result.best.utilization);
    EXPECT_TRUE(std::is_sorted(result.best_utilizations.rbegin(), result.best_utilizations.rend()));
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end())) << "the best never gets worse";
    const GeneticResult again = geneticSearch(c.state, c.types, c.items, options, 5, {});
    EXPECT_EQ(again.best.sequence, result.best.sequence);
    EXPECT_EQ(again.best_utilizations, result.best_utilizations);
    ASSERT_FALSE(HasFailure()) << "seed 2, round " << round;
  }
}

TEST(GeneticSearch, isNeverWorseThanTheFourSortedSequences) {
  std::mt19937_64 rng(3);
  for (int round = 0; round < 100; ++round) {
    const Case c = randomCase(rng);
    GeneticOptions options;
    const double found = geneticSearch(c.state, c.types, c.items, options, 1, {}).best.utilization;
    const auto sizeOf = [&](int item) { return c.types[static_cast<std::size_t>(item)].size; };
    std::vector<int> sorted = c.items;
    std::sort(sorted.begin(), sorted.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](int a, int b) { return volume(sizeOf(a)) > volume(sizeOf(b)); });
    EXPECT_GE(found, packSequence(c.state, c.types, sorted, options.rule).utilization)
        << "seed 3, round " << round;
  }
}

TEST(GeneticSearch, endsEarlyWhenEverythingIsPacked) {
  const std::vector<ItemType> types{{"A", {50, 50, 50}, {}}};
  const std::vector<int> items(8, 0);
  const GeneticResult result =
      geneticSearch(PalletState(PalletRules{{100, 100, 100}}), types, items, {}, 8, {});
  EXPECT_EQ(result.generations_run, 0);
  EXPECT_DOUBLE_EQ(result.best.utilization, 1.0);
  EXPECT_EQ(result.best_utilizations.size(), 1U) << "equal sequences are packed once";
}

TEST(GeneticSearch, answersWhenStoppedAtOnceAndWithNothingToPack) {
  const std::vector<ItemType> types{{"A", {60, 60, 60}, {}}, {"B", {70, 10, 10}, {}}};
  int asked = 0;
  const auto stop = [&] { return ++asked > 0; };
  const GeneticResult stopped =
      geneticSearch(PalletState(PalletRules{{100, 100, 100}}), types, {0, 1, 0}, {}, 8, stop);
  EXPECT_EQ(stopped.best_utilizations.size(), 1U);
  EXPECT_EQ(stopped.best.placements.size() + stopped.best.unpacked.size(), 3U);
  const GeneticResult empty = geneticSearch(PalletState(PalletRules{{100, 100, 100}}), types, {}, {}, 8, {});
  EXPECT_TRUE(empty.best.sequence.empty());
  EXPECT_DOUBLE_EQ(empty.best.utilization, 0.0);
  EXPECT_TRUE(geneticSearch(PalletState(PalletRules{{100, 100, 100}}), types, {0}, {}, 0, {})
                  .best_utilizations.empty());
}

TEST(GeneticSearch, refusesBrokenOptionsAndItems) {
  EXPECT_TRUE(problems(GeneticOptions{}).empty());
  GeneticOptions options;
  options.population = 0;
  options.elite = 3;
  options.generations = -1;
  options.prob_tournament = 1.5;
  options.prob_crossover = -0.1;
  options.prob_mutation = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problems(options).size(), 6U);
  const PalletState state(PalletRules{{100, 100, 100}});
  EXPECT_THROW(geneticSearch(state, {}, {}, options, 1, {}), std::invalid_argument);
  EXPECT_THROW(geneticSearch(state, {}, {0}, GeneticOptions{}, 1, {}), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::packing
