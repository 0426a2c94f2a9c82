#include <chrono>
#include <numeric>
#include <thread>

#include <gtest/gtest.h>

#include <mixed_palletizing/planning/pallet_session.hpp>
#include <mixed_palletizing/planning/ponderer.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongEnough{20};

PlannerOptions counted() {
  PlannerOptions options;
  options.best.samples = 6;
  options.best.candidates = 3;
  return options;
}

bool never() { return false; }

/// Everything that matters of a decision.
std::string digest(const Decision& decision) {
  std::string text = decision.chosen ? std::to_string(*decision.chosen) : "none";
  for (const PickOption& option : decision.options) {
    text += " " + std::to_string(option.placement.origin.x) + "," +
            std::to_string(option.placement.origin.y) + "," + std::to_string(option.placement.origin.z) +
            "," + std::to_string(option.placement.size.x) + "," + std::to_string(option.future.playouts) +
            option.reason;
    for (const double cost : option.future_costs) text += ":" + std::to_string(cost);
  }
  return text;
}

/// Plays an order's arrival through a session, three visible; every fourth box fails, every fifth is discarded.
/// `pause`: after every report, what the robot takes.
std::vector<std::string> play(PalletSession& session, const packing::Order& order, std::uint64_t seed,
                              std::chrono::milliseconds pause, int* pondered) {
  std::mt19937_64 rng(seed);
  std::vector<int> to_come = test::shuffledItems(order, rng);
  std::vector<int> here;
  std::vector<std::string> decisions;
  EXPECT_TRUE(session.start("p", order, true).ok());
  for (int count = 1; !(to_come.empty() && here.empty()); ++count) {
    for (; here.size() < 3 && !to_come.empty(); to_come.pop_back()) here.push_back(to_come.back());
    std::shuffle(here.begin(), here.end(), rng);
    const ChooseReply reply = session.choose("", here, never, 0.0, {}, 1e9);
    decisions.push_back(digest(reply.decision));
    if (pondered != nullptr) *pondered += reply.pondered ? 1 : 0;
    std::this_thread::sleep_for(pause);
    if (!reply.decision.chosen) {
      EXPECT_TRUE(session.report(reply.decision_id, PickOutcome::kDiscarded, {}, {}).ok());
      here.clear();
      continue;
    }
    const auto outcome = count % 4 == 0   ? PickOutcome::kFailed
                         : count % 5 == 0 ? PickOutcome::kDiscarded
                                          : PickOutcome::kPlaced;
    EXPECT_TRUE(session.report(reply.decision_id, outcome, {}, {}).ok());
    if (outcome != PickOutcome::kFailed) {
      here.erase(here.begin() + static_cast<std::ptrdiff_t>(*reply.decision.chosen));
    }
  }
  return decisions;
}

TEST(PondererTest, countedDecisionsDoNotDependOnIt) {
  std::mt19937_64 rng(301);
  int pondered = 0;
  for (int run = 0; run < 6; ++run) {
    const packing::Order order = test::randomOrder(rng);
    const std::uint64_t seed = rng();
    PalletSession plain(counted());
    PalletSession thinking(counted());
    thinking.ponder();
    const auto expected = play(plain, order, seed, std::chrono::milliseconds(0), nullptr);
    EXPECT_EQ(play(thinking, order, seed, std::chrono::milliseconds(run), &pondered), expected)
        << "seed 301, run " << run;
  }
  EXPECT_GT(pondered, 0);
}

/// A world of a random order, three boxes visible.
ExpectedWorld worldOf(const packing::Order& order, std::mt19937_64& rng) {
  ExpectedWorld world;
  world.pallet = std::make_shared<packing::PalletState>(order);
  world.types = std::make_shared<std::vector<packing::ItemType>>(order.types);
  world.remaining = order.counts;
  world.available = test::shuffledItems(order, rng);
  world.available.resize(std::min<std::size_t>(world.available.size(), 3));
  world.seed = rng();
  return world;
}

packing::Order bigOrder() {
  packing::Order order;
  order.rules.size = {1200, 800, 900};
  for (int i = 0; i < 5; ++i) {
    order.types.push_back({"t" + std::to_string(i), {150 + 30 * i, 110 + 20 * i, 90 + 10 * i}, {}, 0, 0});
    order.counts.push_back(30);
  }
  return order;
}

TEST(PondererTest, whatCameOtherwiseIsNotKnown) {
  std::mt19937_64 rng(302);
  const packing::Order order = bigOrder();
  const ExpectedWorld world = worldOf(order, rng);
  const auto known = [&](const Situation& situation, std::uint64_t seed) {
    Ponderer ponderer(counted());
    ponderer.expect({world}, 1.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return ponderer.take(situation, seed, 1.0, never).has_value();
  };
  EXPECT_TRUE(known(world.situation(), world.seed));
  EXPECT_FALSE(known(world.situation(), world.seed + 1));
  Situation fewer = world.situation();
  fewer.available.pop_back();
  EXPECT_FALSE(known(fewer, world.seed));
  Situation later = world.situation();
  --later.remaining.back();
  EXPECT_FALSE(known(later, world.seed));
  packing::PalletState other(order);
  other.place({0, {0, 0, 0}, order.types[0].size});
  const Situation elsewhere{other, order.types, world.available, world.remaining};
  EXPECT_FALSE(known(elsewhere, world.seed));
}

TEST(PondererTest, whatWasNotBegunIsNotWaitedFor) {
  std::mt19937_64 rng(303);
  const packing::Order order = bigOrder();
  PlannerOptions endless;
  endless.best.samples = 1000000000;
  Ponderer ponderer(endless);
  const ExpectedWorld first = worldOf(order, rng);
  const ExpectedWorld second = worldOf(order, rng);
  ponderer.expect({first, second}, 1.0);
  const Clock::time_point start = Clock::now();
  EXPECT_FALSE(ponderer.take(second.situation(), second.seed, 1.0, never));
  EXPECT_LT(Clock::now() - start, kLongEnough);
}

TEST(PondererTest, stopsWhenItIsToldToAndAtItsEnd) {
  std::mt19937_64 rng(304);
  PlannerOptions endless;
  endless.best.samples = 1000000000;
  const packing::Order order = bigOrder();
  const Clock::time_point start = Clock::now();
  for (int run = 0; run < 20; ++run) {
    Ponderer ponderer(endless);
    const ExpectedWorld world = worldOf(order, rng);
    ponderer.expect({world}, 1.0);
    if (run % 2 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(run));
    if (run % 4 == 0) ponderer.forget();
    const auto at_once = [] { return true; };
    if (run % 4 != 1) continue;
    const auto decision = ponderer.take(world.situation(), world.seed, 1.0, at_once);
    EXPECT_TRUE(!decision || decision->chosen) << "seed 304, run " << run;
  }
  EXPECT_LT(Clock::now() - start, kLongEnough);
}

TEST(PondererTest, lessThoughtThanAskedForIsNotUsed) {
  std::mt19937_64 rng(305);
  const ExpectedWorld world = worldOf(bigOrder(), rng);
  const auto deadline = Clock::now() + std::chrono::milliseconds(1);
  const auto stop = [deadline] { return Clock::now() >= deadline; };
  for (const double asked_ms : {1.0, 1e6}) {
    Ponderer ponderer((PlannerOptions()));
    ponderer.expect({world}, 1.0);
    std::this_thread::sleep_for(std::chrono::seconds(2));  // it ends after 1 ms and what follows
    EXPECT_EQ(ponderer.take(world.situation(), world.seed, asked_ms, stop).has_value(), asked_ms == 1.0);
  }
}

TEST(PondererTest, withoutALimitOrWithAnotherMethodNothingIsKnown) {
  std::mt19937_64 rng(306);
  const ExpectedWorld world = worldOf(bigOrder(), rng);
  PlannerOptions ga;
  ga.method = PlanMethod::kGa;
  for (const PlannerOptions& options : {PlannerOptions(), ga}) {
    Ponderer ponderer(options);
    ponderer.expect({world}, 1.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(ponderer.take(world.situation(), world.seed, 0.0, {}));
  }
}

/// An order that always becomes perfect, so that no weights are looked for: those given stay.
TEST(PondererTest, thoughtsGoOnFromTheWeightsGiven) {
  packing::Order order;
  order.rules.size = {800, 600, 200};
  order.types = {{"quarter", {400, 300, 100}, {}, 0, 0}, {"half", {800, 300, 100}, {}, 0, 0}};
  order.counts = {4, 2};
  const auto pallet = std::make_shared<const packing::PalletState>(order);
  const auto types = std::make_shared<const std::vector<packing::ItemType>>(order.types);
  const ExpectedWorld world{pallet, types, {0, 1}, order.counts, {}, 1};
  PolicyWeights given = tunedPolicyWeights();
  given.front() += 0.25;
  Ponderer ponderer((PlannerOptions()));
  EXPECT_FALSE(ponderer.fitted());
  ponderer.expect({world}, 1e6, given);
  EXPECT_EQ(ponderer.fitted(), given);
  const auto deadline = Clock::now() + kLongEnough;
  std::optional<Decision> decision;
  while (!decision && Clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    decision = ponderer.take(world.situation(), world.seed, 1.0, never);
    if (!decision) ponderer.expect({world}, 1e6, given);
  }
  ASSERT_TRUE(decision);
  EXPECT_EQ(decision->fitted, given);
  EXPECT_EQ(ponderer.fitted(), given);
  ponderer.forget();
  EXPECT_FALSE(ponderer.fitted());
}

}  // namespace
}  // namespace mixed_palletizing::planning
