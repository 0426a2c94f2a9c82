#include "playout_race.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <random>

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

TEST(PlayoutRaceTest, halvingLooksAtAllPairsAndEndsWithFewThatPlayedAsMuch) {
  std::mt19937_64 rng(kSeed);
  int races = 0;
  for (int i = 0; i < 40; ++i) {
    Race race(rng);
    if (!race.open()) continue;
    ++races;
    const std::size_t before = (*race).leader();
    const std::size_t lead = (*race).runners()[before].ends.size();
    const std::size_t pairs = std::min<std::size_t>(race.pairs(), 12);
    (*race).halve(pairs, 2, {});
    const auto& runners = (*race).runners();
    ASSERT_GE(runners.size(), pairs) << "seed " << kSeed << ", order " << i;
    std::size_t racing = 0;
    for (const PlayoutRace::Runner& runner : runners) {
      EXPECT_GE(runner.ends.size(), 2U) << "seed " << kSeed << ", order " << i;
      if (!runner.racing) continue;
      ++racing;
      EXPECT_GE(runner.ends.size(), lead) << "seed " << kSeed << ", order " << i;
    }
    EXPECT_LE(racing, 3U);
    EXPECT_TRUE(runners[before].racing) << "seed " << kSeed << ", order " << i;
    const std::size_t now = (*race).leader();
    EXPECT_GE((*race).meanValue(runners[now]), (*race).meanValue(runners[before]));
  }
  EXPECT_GE(races, 10) << "seed " << kSeed;
}

TEST(PlayoutRaceTest, theBetterHalfPlaysOn) {
  std::mt19937_64 rng(kSeed + 1);
  for (int i = 0; i < 12; ++i) {
    Race race(rng);
    if (!race.open()) continue;
    const std::size_t before = (*race).leader();
    constexpr std::size_t kFutures =
        4 * kSamples;  // more than any has played: what they played follows from the halving
    (*race).halve(race.pairs(), kFutures, {});
    double best_out = -std::numeric_limits<double>::infinity();  // of those that dropped out at first
    double worst_in = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < race.pairs(); ++r) {
      const PlayoutRace::Runner& runner = (*race).runners()[r];
      const double value = valueOfFirst(runner, kFutures, race.palletVolume());
      if (runner.ends.size() == kFutures && !runner.racing) best_out = std::max(best_out, value);
      if (runner.ends.size() > kFutures && r != before) worst_in = std::min(worst_in, value);
    }
    EXPECT_GE(worst_in, best_out) << "seed " << kSeed + 1 << ", order " << i;
  }
}

TEST(PlayoutRaceTest, cutHalvingLeavesTheLeaderThatPlayedMost) {
  std::mt19937_64 rng(kSeed + 2);
  for (int i = 0; i < 40; ++i) {
    Race race(rng);
    if (!race.open()) continue;
    const std::size_t before = (*race).leader();
    (*race).halve(race.pairs(), 2, [calls = std::make_shared<int>(0)] { return ++*calls > 3; });
    EXPECT_EQ((*race).leader(), before) << "seed " << kSeed + 2 << ", order " << i;
  }
}

}  // namespace
}  // namespace mixed_palletizing::planning
