#include "playout_race.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "future_value.hpp"
#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

constexpr std::uint64_t kSeed = 91;
constexpr int kLanes = 4;
constexpr int kSamples = 16;

/// A race on a random order, three items visible, all pairs of which a few have raced.
class Race {
 public:
  explicit Race(std::mt19937_64& rng)
      : order_(test::randomOrder(rng)),
        pallet_(order_),
        situation_{pallet_, order_.types, visible(rng), order_.counts},
        futures_(situation_, kSeed) {
    engines_.emplace_back(order_.types, order_.rules, tunedPolicyWeights());
    std::vector<int> types = situation_.available;
    std::sort(types.begin(), types.end());
    types.erase(std::unique(types.begin(), types.end()), types.end());
    pairs_ =
        scoredPlacements(pallet_, types, order_.counts, GripperEnvelope(), engines_.front().policy(), {});
    if (pairs_.empty()) return;
    race_.emplace(situation_, pairs_, kLanes, engines_, futures_);
    race_->run(kSamples, {});
  }

  bool open() const { return race_ && pairs_.size() > kLanes && !futures_.onlyOne(); }
  PlayoutRace& operator*() { return *race_; }
  double palletVolume() const { return static_cast<double>(packing::volume(order_.rules.size)); }
  std::size_t pairs() const { return pairs_.size(); }

 private:
  std::vector<int> visible(std::mt19937_64& rng) const {
    std::vector<int> items = test::shuffledItems(order_, rng);
    items.resize(std::min<std::size_t>(items.size(), 3));
    return items;
  }

  packing::Order order_;
  packing::PalletState pallet_;
  Situation situation_;
  SampledFutures futures_;
  std::vector<Playout> engines_;
  std::vector<ScoredPlacement> pairs_;
  std::optional<PlayoutRace> race_;
};

double valueOfFirst(const PlayoutRace::Runner& runner, std::size_t count, double pallet_volume) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += futureValue(runner.ends[i], pallet_volume);
  return sum;
}

/// Those of `orders` random orders with more pairs than lanes and more futures than one.
std::vector<std::unique_ptr<Race>> openRaces(std::uint64_t seed, int orders) {
  std::mt19937_64 rng(seed);
  std::vector<std::unique_ptr<Race>> races;
  for (int i = 0; i < orders; ++i) {
    auto race = std::make_unique<Race>(rng);
    if (race->open()) races.push_back(std::move(race));
  }
  EXPECT_GE(static_cast<int>(races.size()), orders / 4) << "seed " << seed;
  return races;
}

TEST(PlayoutRaceTest, halvingLooksAtAllPairsAndEndsWithFewThatPlayedAsMuch) {
  for (const auto& open : openRaces(kSeed, 40)) {
    PlayoutRace& race = **open;
    const std::size_t before = race.leader();
    const std::size_t lead = race.runners()[before].ends.size();
    const std::size_t pairs = std::min<std::size_t>(open->pairs(), 12);
    race.halve(pairs, 2, {});
    const auto& runners = race.runners();
    ASSERT_GE(runners.size(), pairs) << "seed " << kSeed;
    std::size_t racing = 0;
    for (const PlayoutRace::Runner& runner : runners) {
      EXPECT_GE(runner.ends.size(), 2U) << "seed " << kSeed;
      if (!runner.racing) continue;
      ++racing;
      EXPECT_GE(runner.ends.size(), lead) << "seed " << kSeed;
    }
    EXPECT_LE(racing, 3U);
    EXPECT_TRUE(runners[before].racing) << "seed " << kSeed;
    EXPECT_GE(race.meanValue(runners[race.leader()]), race.meanValue(runners[before]));
  }
}

TEST(PlayoutRaceTest, theBetterHalfPlaysOn) {
  for (const auto& open : openRaces(kSeed + 1, 12)) {
    PlayoutRace& race = **open;
    const std::size_t before = race.leader();
    constexpr std::size_t kFutures =
        4 * kSamples;  // more than any has played: what they played follows from the halving
    race.halve(open->pairs(), kFutures, {});
    double best_out = -std::numeric_limits<double>::infinity();  // of those that dropped out at first
    double worst_in = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < open->pairs(); ++r) {
      const PlayoutRace::Runner& runner = race.runners()[r];
      const double value = valueOfFirst(runner, kFutures, open->palletVolume());
      if (runner.ends.size() == kFutures && !runner.racing) best_out = std::max(best_out, value);
      if (runner.ends.size() > kFutures && r != before) worst_in = std::min(worst_in, value);
    }
    EXPECT_GE(worst_in, best_out) << "seed " << kSeed + 1;
  }
}

TEST(PlayoutRaceTest, cutHalvingLeavesTheLeaderThatPlayedMost) {
  for (const auto& open : openRaces(kSeed + 2, 40)) {
    PlayoutRace& race = **open;
    const std::size_t before = race.leader();
    race.halve(open->pairs(), 2, [calls = std::make_shared<int>(0)] { return ++*calls > 3; });
    EXPECT_EQ(race.leader(), before) << "seed " << kSeed + 2;
  }
}

}  // namespace
}  // namespace mixed_palletizing::planning
