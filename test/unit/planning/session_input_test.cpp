// Whatever a session is asked: a status, a message, and an unchanged state.
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include <mixed_palletizing/planning/pallet_session.hpp>

#include "journal_support.hpp"

namespace mixed_palletizing::planning {
namespace {

using test::digest;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kMany = 10000;

packing::Order smallOrder() {
  packing::Order order;
  order.rules.size = {600, 400, 200};
  order.types = {{"big", {300, 400, 200}, {}, 0, 0}, {"flat", {300, 400, 100}, {}, 0, 0}};
  order.counts = {1, 2};
  return order;
}

/// With one box placed (decision 2), decision 1 stale, and decision 3 for request "r" pending.
class SessionInput : public testing::Test {
 protected:
  SessionInput() : session_(test::dblf()) {
    EXPECT_TRUE(session_.start("p", smallOrder(), false).ok());
    EXPECT_EQ(session_.choose("mine", {1}, {}).decision_id, 1U);
    EXPECT_EQ(session_.choose("yours", {0}, {}).decision_id, 2U);
    EXPECT_TRUE(session_.report(2, PickOutcome::kPlaced, {}, {}).ok());
    EXPECT_EQ(session_.choose("r", {1}, {}).decision_id, 3U);
  }

  PalletSession session_;
};

struct Start {
  const char* name;
  std::function<void(packing::Order&, OrderKnowledge&)> spoil;
};

TEST_F(SessionInput, badOrdersAreRefused) {
  constexpr int kAbsurd = std::numeric_limits<int>::max();
  const std::vector<Start> table{
      {"zero side", [](auto& o, auto&) { o.types[0].size.x = 0; }},
      {"negative side", [](auto& o, auto&) { o.types[0].size.y = -300; }},
      {"absurd side", [](auto& o, auto&) { o.types[0].size.z = kAbsurd; }},
      {"zero pallet", [](auto& o, auto&) { o.rules.size.x = 0; }},
      {"negative pallet", [](auto& o, auto&) { o.rules.size.y = -1; }},
      {"absurd pallet", [](auto& o, auto&) { o.rules.size.z = kAbsurd; }},
      {"negative gap", [](auto& o, auto&) { o.rules.gap = -1; }},
      {"NaN support", [](auto& o, auto&) { o.rules.min_support_ratio = kNan; }},
      {"no support", [](auto& o, auto&) { o.rules.min_support_ratio = 0.0; }},
      {"NaN weight", [](auto& o, auto&) { o.types[0].weight_kg = kNan; }},
      {"negative weight", [](auto& o, auto&) { o.types[0].weight_kg = -1.0; }},
      {"NaN load", [](auto& o, auto&) { o.types[0].max_load_kg = kNan; }},
      {"NaN pallet weight", [](auto& o, auto&) { o.rules.max_weight_kg = kNan; }},
      {"negative count", [](auto& o, auto&) { o.counts[0] = -1; }},
      {"absurd count", [](auto& o, auto&) { o.counts[0] = kAbsurd; }},
      {"no items",
       [](auto& o, auto&) {
         o.counts = {0, 0};
       }},
      {"a count missing", [](auto& o, auto&) { o.counts.pop_back(); }},
      {"no types", [](auto& o, auto&) { o.types.clear(), o.counts.clear(); }},
      {"same name", [](auto& o, auto&) { o.types[1].name = o.types[0].name; }},
      {"no rotation",
       [](auto& o, auto&) {
         o.types[0].rotations.vertical = {false, false, false};
       }},
      {"NaN forecast",
       [](auto&, auto& k) {
         k = {Knowledge::kForecast, {kNan, 1.0}};
       }},
      {"short forecast",
       [](auto&, auto& k) {
         k = {Knowledge::kForecast, {1.0}};
       }},
      {"types with counts", [](auto&, auto& k) { k.kind = Knowledge::kTypes; }},
  };
  const std::string before = digest(session_);
  for (const Start& row : table) {
    packing::Order order = smallOrder();
    OrderKnowledge knowledge;
    row.spoil(order, knowledge);
    const SessionReply reply = session_.start("q", order, true, knowledge);
    EXPECT_EQ(reply.status, SessionStatus::kBadRequest) << row.name;
    EXPECT_FALSE(reply.message.empty()) << row.name;
    EXPECT_EQ(digest(session_), before) << row.name;
  }
  EXPECT_EQ(session_.start("", smallOrder(), true).status, SessionStatus::kBadRequest);
  EXPECT_EQ(session_.start("q", smallOrder(), false).status, SessionStatus::kPalletOpen);
  EXPECT_EQ(digest(session_), before);
}

TEST_F(SessionInput, badChoicesAreRefused) {
  struct Row {
    const char* name;
    const char* request;
    std::vector<int> available;
    ChooseStatus status;
  };
  const std::vector<Row> table{
      {"nothing", "", {}, ChooseStatus::kBadRequest},
      {"no such type", "", {2}, ChooseStatus::kBadRequest},
      {"negative type", "", {-1}, ChooseStatus::kBadRequest},
      {"none left", "", {0}, ChooseStatus::kBadRequest},
      {"more than left", "", {1, 1, 1}, ChooseStatus::kBadRequest},
      {"ten thousand", "", std::vector<int>(kMany, 1), ChooseStatus::kBadRequest},
      {"same request, other boxes", "r", {1, 1}, ChooseStatus::kConflict},
  };
  const std::string before = digest(session_);
  for (const Row& row : table) {
    const ChooseReply reply = session_.choose(row.request, row.available, {});
    EXPECT_EQ(reply.status, row.status) << row.name;
    EXPECT_FALSE(reply.message.empty()) << row.name;
    EXPECT_EQ(reply.decision_id, 0U) << row.name;
    EXPECT_EQ(digest(session_), before) << row.name;
  }
}

TEST_F(SessionInput, badReportsAreRefused) {
  struct Row {
    const char* name;
    std::uint64_t decision;
    PickOutcome outcome;
    std::optional<packing::Placement> measured;
    std::vector<std::size_t> discarded;
    SessionStatus status;
  };
  const packing::Vec3 flat{300, 400, 100};
  const auto placed = PickOutcome::kPlaced;
  const auto bad = SessionStatus::kBadRequest;
  const std::vector<Row> table{
      {"never made", 99, placed, {}, {}, SessionStatus::kUnknownDecision},
      {"none", 0, placed, {}, {}, SessionStatus::kUnknownDecision},
      {"stale", 1, placed, {}, {}, SessionStatus::kUnknownDecision},
      {"reported otherwise", 2, PickOutcome::kFailed, {}, {}, SessionStatus::kConflict},
      {"on another box", 3, placed, packing::Placement{1, {0, 0, 0}, flat}, {}, bad},
      {"in the air", 3, placed, packing::Placement{1, {300, 0, 50}, flat}, {}, bad},
      {"outside", 3, placed, packing::Placement{1, {400, 0, 0}, flat}, {}, bad},
      {"far outside", 3, placed, packing::Placement{1, {2000000000, 0, 0}, flat}, {}, bad},
      {"turned", 3, placed, packing::Placement{1, {300, 0, 0}, {400, 300, 100}}, {}, bad},
      {"another type", 3, placed, packing::Placement{0, {300, 0, 0}, {300, 400, 200}}, {}, bad},
      {"no such type", 3, placed, packing::Placement{7, {300, 0, 0}, flat}, {}, bad},
      {"placed and discarded", 3, placed, {}, {0}, bad},
      {"failed and measured", 3, PickOutcome::kFailed, packing::Placement{1, {300, 0, 0}, flat}, {}, bad},
      {"discarded twice", 3, PickOutcome::kDiscarded, {}, {0, 0}, bad},
      {"discarded another", 3, PickOutcome::kDiscarded, {}, {1}, bad},
  };
  const std::string before = digest(session_);
  for (const Row& row : table) {
    const SessionReply reply = session_.report(row.decision, row.outcome, row.measured, row.discarded);
    EXPECT_EQ(reply.status, row.status) << row.name << ": " << reply.message;
    EXPECT_FALSE(reply.message.empty()) << row.name;
    EXPECT_EQ(digest(session_), before) << row.name;
  }
  EXPECT_TRUE(session_.report(3, placed, {}, {}).ok());
}

}  // namespace
}  // namespace mixed_palletizing::planning
