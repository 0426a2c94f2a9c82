#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include <mixed_palletizing/planning/knowledge.hpp>
#include <mixed_palletizing/planning/pallet_session.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

packing::Order twoTypes(int a, int b) {
  packing::Order order;
  order.rules.size = {400, 400, 400};
  order.types = {{"a", {200, 200, 200}, {}, 0, 0}, {"b", {200, 200, 100}, {}, 0, 0}};
  order.counts = {a, b};
  return order;
}

TEST(KnowledgeTest, badOnesAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    const char* name;
    packing::Order order;
    OrderKnowledge knowledge;
    const char* words;  ///< "" = sound
  };
  const std::vector<Case> cases{
      {"a set", twoTypes(1, 0), {}, ""},
      {"an empty set", twoTypes(0, 0), {}, "no items"},
      {"a set with a forecast", twoTypes(1, 1), {Knowledge::kSet, {1.0, 1.0}}, "no forecast"},
      {"a forecast", twoTypes(1, 0), {Knowledge::kForecast, {0.0, 2.5}}, ""},
      {"a forecast alone", twoTypes(0, 0), {Knowledge::kForecast, {0.0, 2.5}}, ""},
      {"a short forecast", twoTypes(1, 0), {Knowledge::kForecast, {1.0}}, "1 counts for 2 types"},
      {"no forecast", twoTypes(1, 0), {Knowledge::kForecast, {}}, "0 counts for 2 types"},
      {"NaN", twoTypes(1, 0), {Knowledge::kForecast, {nan, 1.0}}, "expected[0]"},
      {"negative", twoTypes(1, 0), {Knowledge::kForecast, {1.0, -1.0}}, "expected[1]"},
      {"infinite", twoTypes(1, 0), {Knowledge::kForecast, {1.0, 1.0 / 0.0}}, "expected[1]"},
      {"too many", twoTypes(1, 0), {Knowledge::kForecast, {6e4, 6e4}}, "in all"},
      {"types", twoTypes(0, 0), {Knowledge::kTypes, {}}, ""},
      {"types with counts", twoTypes(0, 1), {Knowledge::kTypes, {}}, "must all be 0"},
      {"negative counts", twoTypes(0, -1), {Knowledge::kTypes, {}}, "counts[1]"},
      {"no types", packing::Order{{{400, 400, 400}}, {}, {}}, {Knowledge::kTypes, {}}, "no items"},
  };
  for (const Case& c : cases) {
    const std::vector<std::string> found = problems(c.order, c.knowledge);
    EXPECT_EQ(found.empty(), *c.words == '\0') << c.name;
    bool named = *c.words == '\0';
    for (const std::string& line : found) named = named || line.find(c.words) != std::string::npos;
    EXPECT_TRUE(named) << c.name << ": " << (found.empty() ? "" : found.front());
  }
}

TEST(KnowledgeTest, expectedItemsAreUsedUpByThoseThatCome) {
  const packing::Order order = twoTypes(2, 0);
  const packing::PalletState pallet(order);
  const OrderKnowledge knowledge{Knowledge::kForecast, {1.5, 3.0}};
  const Situation none = situationOf(pallet, order, knowledge, {0, 0}, {});
  EXPECT_EQ(none.remaining, (std::vector<int>{2, 0}));
  EXPECT_EQ(none.forecast, (std::vector<double>{1.5, 3.0}));
  const Situation some = situationOf(pallet, order, knowledge, {1, 1}, {0, 0, 1});
  EXPECT_EQ(some.remaining, (std::vector<int>{2, 1}));  // those at hand are sure
  EXPECT_EQ(some.forecast, (std::vector<double>{0.5, 1.0}));
  const Situation more = situationOf(pallet, order, knowledge, {5, 9}, {1});
  EXPECT_EQ(more.remaining, (std::vector<int>{0, 1}));
  EXPECT_EQ(more.forecast, (std::vector<double>{0.0, 0.0}));
}

TEST(KnowledgeTest, typesFillEqualSharesOfTheFreeRoom) {
  const packing::Order order = twoTypes(0, 0);
  packing::PalletState pallet(order);
  pallet.place({0, {0, 0, 0}, order.types[0].size});
  // 64 litres, 8 on the pallet, 8 + 4 at hand: 44 are left, 22 for each type.
  const Situation situation = situationOf(pallet, order, {Knowledge::kTypes, {}}, {1, 0}, {0, 1});
  EXPECT_EQ(situation.remaining, (std::vector<int>{1, 1}));
  EXPECT_EQ(situation.forecast, (std::vector<double>{2.75, 5.5}));
}

TEST(KnowledgeTest, theAnswerTellsWhatWasAssumed) {
  const packing::Order order = twoTypes(2, 0);
  const packing::PalletState pallet(order);
  const auto text = [&](Knowledge kind, std::vector<double> expected) {
    return assumptionOf(situationOf(pallet, order, {kind, std::move(expected)}, {0, 0}, {0}), kind);
  };
  EXPECT_EQ(text(Knowledge::kSet, {}),
            "1 more boxes come, every sequence as likely as another; 1 is visible at a time");
  EXPECT_NE(text(Knowledge::kForecast, {0.5, 1.0}).find("1 more boxes are sure to come, 1.5 are expected"),
            std::string::npos);
  EXPECT_NE(text(Knowledge::kTypes, {}).find("nothing is known but the types"), std::string::npos);
}

/// Whatever is known and however many are visible: boxes of the types come as long as any fits, every decision
/// is answered, and taking all back leads to the start.
TEST(KnowledgeTest, palletsAreFilledWithAnyKnowledgeAndAnyNumberVisible) {
  std::mt19937_64 rng(311);
  for (int run = 0; run < 30; ++run) {
    packing::Order order = test::randomOrder(rng);
    const auto kind = static_cast<Knowledge>(run % 3);
    const int n_pick = std::array<int, 5>{1, 2, 3, 5, 10}.at(static_cast<std::size_t>(rng() % 5));
    std::vector<int> to_come = test::shuffledItems(order, rng);
    OrderKnowledge knowledge{kind, {}};
    for (int& count : order.counts) {
      if (kind == Knowledge::kForecast) knowledge.expected.push_back(count * 0.5);
      if (kind == Knowledge::kForecast) count /= 2;
      if (kind == Knowledge::kTypes) count = 0;
    }
    PlannerOptions options;
    options.best.samples = 2;
    options.best.candidates = 2;
    PalletSession session(options);
    ASSERT_TRUE(session.start("p", order, false, knowledge).ok()) << "seed 311, run " << run;
    const std::vector<int> at_first = session.remaining();
    std::vector<int> here;
    int changes = 0;
    while (!(to_come.empty() && here.empty())) {
      for (; static_cast<int>(here.size()) < n_pick && !to_come.empty(); to_come.pop_back()) {
        here.push_back(to_come.back());
      }
      ASSERT_FALSE(session.complete()) << "seed 311, run " << run;
      const ChooseReply reply = session.choose("", here, {});
      ASSERT_TRUE(reply.status == ChooseStatus::kPick || reply.status == ChooseStatus::kNoneFits)
          << "seed 311, run " << run << ": " << reply.message;
      EXPECT_FALSE(reply.assumed.empty());
      const bool placed = reply.decision.chosen.has_value();
      ASSERT_TRUE(
          session.report(reply.decision_id, placed ? PickOutcome::kPlaced : PickOutcome::kDiscarded, {}, {})
              .ok());
      ++changes;
      if (placed) {
        here.erase(here.begin() + static_cast<std::ptrdiff_t>(*reply.decision.chosen));
      } else {
        here.clear();
      }
    }
    EXPECT_EQ(session.complete(), kind == Knowledge::kSet) << "seed 311, run " << run;
    for (; changes > 0; --changes) ASSERT_TRUE(session.undoLast().ok());
    EXPECT_EQ(session.remaining(), at_first) << "seed 311, run " << run;
    EXPECT_EQ(session.choose("", {0}, {}).status, ChooseStatus::kPick);
    EXPECT_EQ(session.choose("", {-1}, {}).status, ChooseStatus::kBadRequest);
    EXPECT_EQ(session.choose("", {static_cast<int>(order.types.size())}, {}).status,
              ChooseStatus::kBadRequest);
  }
}

}  // namespace
}  // namespace mixed_palletizing::planning
