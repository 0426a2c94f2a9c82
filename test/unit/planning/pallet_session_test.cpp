#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/planning/pallet_session.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

using packing::Placement;

const packing::StopCallback kNever;

PlannerOptions dblf() {
  PlannerOptions options;
  options.method = PlanMethod::kDblf;
  return options;
}

packing::Order smallOrder() {
  packing::Order order;
  order.rules.size = {300, 200, 200};
  order.types = {{"a", {100, 100, 100}, {}, 2.0, 0}, {"b", {200, 100, 100}, {}, 6.0, 0}};
  order.counts = {4, 2};
  return order;
}

PalletSession started(const packing::Order& order = smallOrder()) {
  PalletSession session(dblf());
  EXPECT_TRUE(session.start("p1", order, false).ok());
  return session;
}

int total(const std::vector<int>& counts) { return std::accumulate(counts.begin(), counts.end(), 0); }

TEST(PalletSession, answersBeforeStart) {
  PalletSession session{PlannerOptions()};
  PalletSummary summary;
  EXPECT_FALSE(session.open());
  EXPECT_EQ(session.pallet(), nullptr);
  EXPECT_EQ(session.order(), nullptr);
  EXPECT_EQ(session.palletId(), "");
  EXPECT_TRUE(session.remaining().empty());
  EXPECT_EQ(session.pendingDecision(), nullptr);
  EXPECT_EQ(session.choose("r", {0}, kNever).status, ChooseStatus::kNoPallet);
  EXPECT_EQ(session.report(1, PickOutcome::kPlaced, {}, {}).status, SessionStatus::kNoPallet);
  EXPECT_EQ(session.undoLast().status, SessionStatus::kNoPallet);
  EXPECT_EQ(session.close(summary).status, SessionStatus::kNoPallet);
  EXPECT_EQ(session.revision(), 0U);
  PlannerOptions bad;
  bad.n_cost = 0;
  EXPECT_THROW(PalletSession{bad}, std::invalid_argument);
}

TEST(PalletSession, startRefusesAnOpenPalletAndBadOrders) {
  PalletSession session = started();
  EXPECT_EQ(session.start("p2", smallOrder(), false).status, SessionStatus::kPalletOpen);
  packing::Order bad = smallOrder();
  bad.types[0].size.x = 0;
  EXPECT_EQ(session.start("p2", bad, true).status, SessionStatus::kBadRequest);
  EXPECT_EQ(session.start("", smallOrder(), true).status, SessionStatus::kBadRequest);
  EXPECT_EQ(session.palletId(), "p1");
  EXPECT_TRUE(session.start("p2", smallOrder(), true).ok());
  EXPECT_EQ(session.palletId(), "p2");
}

TEST(PalletSession, theSameRequestGetsTheSameAnswer) {
  PalletSession session = started();
  const ChooseReply first = session.choose("r1", {0, 1}, kNever);
  ASSERT_EQ(first.status, ChooseStatus::kPick) << first.message;
  const ChooseReply other = session.choose("r2", {1, 0}, kNever);
  EXPECT_NE(other.decision_id, first.decision_id);
  const ChooseReply again = session.choose("r1", {0, 1}, kNever);
  EXPECT_EQ(again.decision_id, first.decision_id);
  EXPECT_EQ(again.decision.chosen, first.decision.chosen);
  EXPECT_EQ(session.choose("r1", {0}, kNever).status, ChooseStatus::kConflict);
  EXPECT_NE(session.choose("", {0, 1}, kNever).decision_id, session.choose("", {0, 1}, kNever).decision_id);
  EXPECT_EQ(session.revision(), 1U);
  EXPECT_TRUE(session.report(first.decision_id, PickOutcome::kPlaced, {}, {}).ok());
  EXPECT_NE(session.choose("r1", {0, 1}, kNever).decision_id, first.decision_id);
  EXPECT_EQ(session.report(other.decision_id, PickOutcome::kPlaced, {}, {}).status,
            SessionStatus::kUnknownDecision);
}

TEST(PalletSession, chooseRefusesWhatTheOrderDoesNotHold) {
  PalletSession session = started();
  for (const std::vector<int>& bad : {std::vector<int>{}, {2}, {-1}, {1, 1, 1}, std::vector<int>(10000, 0)}) {
    const ChooseReply reply = session.choose("r", bad, kNever);
    EXPECT_EQ(reply.status, ChooseStatus::kBadRequest);
    EXPECT_FALSE(reply.message.empty());
  }
  EXPECT_EQ(session.summary().decisions, 0);
}

TEST(PalletSession, reportsAreIdempotent) {
  PalletSession session = started();
  const std::uint64_t id = session.choose("r1", {0}, kNever).decision_id;
  EXPECT_EQ(session.report(id + 1, PickOutcome::kPlaced, {}, {}).status, SessionStatus::kUnknownDecision);
  EXPECT_EQ(session.report(0, PickOutcome::kPlaced, {}, {}).status, SessionStatus::kUnknownDecision);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(session.report(id, PickOutcome::kPlaced, {}, {}).ok());
  EXPECT_EQ(session.pallet()->placements().size(), 1U);
  EXPECT_EQ(session.remaining(), (std::vector<int>{3, 2}));
  EXPECT_EQ(session.report(id, PickOutcome::kFailed, {}, {}).status, SessionStatus::kConflict);
  EXPECT_EQ(session.revision(), 2U);
  EXPECT_TRUE(session.undoLast().ok());
  EXPECT_EQ(session.report(id, PickOutcome::kPlaced, {}, {}).status, SessionStatus::kUnknownDecision);
  EXPECT_EQ(session.remaining(), (std::vector<int>{4, 2}));
  EXPECT_EQ(session.undoLast().status, SessionStatus::kNothingToUndo);
}

TEST(PalletSession, failedLeavesTheState) {
  PalletSession session = started();
  const std::uint64_t id = session.choose("r1", {0}, kNever).decision_id;
  EXPECT_NE(session.pendingDecision(), nullptr);
  EXPECT_TRUE(session.report(id, PickOutcome::kFailed, {}, {}).ok());
  EXPECT_EQ(session.pendingDecision(), nullptr);
  EXPECT_EQ(session.revision(), 1U);
  EXPECT_EQ(session.remaining(), smallOrder().counts);
  EXPECT_TRUE(session.pallet()->placements().empty());
  EXPECT_EQ(session.undoLast().status, SessionStatus::kNothingToUndo);
  EXPECT_EQ(session.choose("r2", {0}, kNever).status, ChooseStatus::kPick);
}

TEST(PalletSession, measuredPlacementsMustBeValid) {
  PalletSession session = started();
  const std::uint64_t first = session.choose("r1", {0}, kNever).decision_id;
  const Placement measured{0, {20, 7, 0}, {100, 100, 100}};
  EXPECT_TRUE(session.report(first, PickOutcome::kPlaced, measured, {}).ok());
  EXPECT_EQ(session.pallet()->placements().back(), measured);
  const std::uint64_t second = session.choose("r2", {0}, kNever).decision_id;
  const auto refused = [&](const Placement& placement, const char* word) {
    const SessionReply reply = session.report(second, PickOutcome::kPlaced, placement, {});
    EXPECT_EQ(reply.status, SessionStatus::kBadRequest);
    EXPECT_NE(reply.message.find(word), std::string::npos) << reply.message;
  };
  refused({0, {50, 50, 0}, {100, 100, 100}}, "overlaps");
  refused({0, {30, 7, 100}, {100, 100, 100}}, "support");
  refused({0, {0, 0, 150}, {100, 100, 100}}, "");
  refused({0, {-5, 0, 0}, {100, 100, 100}}, "");
  refused({1, {150, 0, 0}, {100, 100, 100}}, "type");
  refused({0, {150, 0, 0}, {100, 100, 90}}, "may not stand");
  EXPECT_EQ(session.report(second, PickOutcome::kFailed, measured, {}).status, SessionStatus::kBadRequest);
  EXPECT_EQ(session.pallet()->placements().size(), 1U);
  EXPECT_TRUE(session.report(second, PickOutcome::kPlaced, {}, {}).ok());
}

TEST(PalletSession, discardedItemsLeaveTheOrder) {
  packing::Order order = smallOrder();
  order.rules.size = {200, 100, 100};
  PalletSession session = started(order);
  EXPECT_TRUE(
      session.report(session.choose("1", {1}, kNever).decision_id, PickOutcome::kPlaced, {}, {}).ok());
  const ChooseReply none = session.choose("2", {0, 1, 0}, kNever);
  ASSERT_EQ(none.status, ChooseStatus::kNoneFits);
  EXPECT_NE(none.message.find("'a'"), std::string::npos) << none.message;
  ASSERT_NE(session.pendingDecision(), nullptr);
  EXPECT_FALSE(session.pendingDecision()->reply.decision.chosen);
  EXPECT_EQ(session.report(none.decision_id, PickOutcome::kPlaced, {}, {}).status,
            SessionStatus::kBadRequest);
  EXPECT_EQ(session.report(none.decision_id, PickOutcome::kDiscarded, {}, {3}).status,
            SessionStatus::kBadRequest);
  EXPECT_EQ(session.report(none.decision_id, PickOutcome::kDiscarded, {}, {1, 1}).status,
            SessionStatus::kBadRequest);
  EXPECT_EQ(session.report(none.decision_id, PickOutcome::kFailed, {}, {1}).status,
            SessionStatus::kBadRequest);
  EXPECT_TRUE(session.report(none.decision_id, PickOutcome::kDiscarded, {}, {}).ok());
  EXPECT_EQ(session.remaining(), (std::vector<int>{2, 0}));
  EXPECT_EQ(session.discarded(), (std::vector<int>{2, 1}));
  const ChooseReply rest = session.choose("3", {0, 0}, kNever);
  EXPECT_TRUE(session.report(rest.decision_id, PickOutcome::kDiscarded, {}, {0}).ok());
  EXPECT_EQ(session.discarded(), (std::vector<int>{3, 1}));
  EXPECT_TRUE(session.undoLast().ok());
  EXPECT_TRUE(session.undoLast().ok());
  EXPECT_EQ(session.discarded(), (std::vector<int>{0, 0}));
  EXPECT_EQ(session.remaining(), (std::vector<int>{4, 1}));
}

TEST(PalletSession, closesWithASummary) {
  PalletSession session = started();
  EXPECT_TRUE(
      session.report(session.choose("1", {1}, kNever).decision_id, PickOutcome::kPlaced, {}, {}).ok());
  EXPECT_TRUE(
      session.report(session.choose("2", {0}, kNever, 50.0).decision_id, PickOutcome::kPlaced, {}, {}).ok());
  PalletSummary summary;
  ASSERT_TRUE(session.close(summary).ok());
  EXPECT_EQ(summary.pallet_id, "p1");
  EXPECT_EQ(summary.placed, 2);
  EXPECT_EQ(summary.remaining, 4);
  EXPECT_NEAR(summary.utilization, 3e6 / 12e6, 1e-12);
  EXPECT_NEAR(summary.center_of_gravity_mm[0], (6.0 * 100 + 2.0 * 250) / 8.0, 1e-9);  // b at 0, a beside it
  EXPECT_NEAR(summary.center_of_gravity_mm[1], 50.0, 1e-9);
  EXPECT_EQ(summary.decisions, 2);
  EXPECT_GE(summary.max_decision_ms, 50.0);
  EXPECT_FALSE(session.open());
  EXPECT_EQ(session.close(summary).status, SessionStatus::kNoPallet);
}

TEST(PalletSession, ordersEndComplete) {
  PalletSession session = started();
  while (total(session.remaining()) > 0) {
    const ChooseReply reply = session.choose("", {session.remaining()[0] > 0 ? 0 : 1}, kNever);
    ASSERT_EQ(reply.status, ChooseStatus::kPick);
    ASSERT_TRUE(session.report(reply.decision_id, PickOutcome::kPlaced, {}, {}).ok());
  }
  EXPECT_EQ(session.choose("", {0}, kNever).status, ChooseStatus::kOrderComplete);
  EXPECT_EQ(session.choose("", {}, kNever).status, ChooseStatus::kOrderComplete);
}

/// What an executive knows for itself: every acknowledged placement and discard, in order.
class Ledger {
 public:
  explicit Ledger(const packing::Order& order) : order_(order) {}

  void placed(const Placement& placement) { entries_.push_back({{}, placement}); }
  void discarded(const std::vector<int>& types) { entries_.push_back({types, {}}); }
  bool undo() {
    if (entries_.empty()) return false;
    entries_.pop_back();
    return true;
  }

  void expectSame(const PalletSession& session, int run) const {
    std::vector<int> remaining = order_.counts;
    std::vector<int> discarded(remaining.size(), 0);
    std::vector<Placement> placements;
    packing::PalletState pallet(order_.rules);
    for (const auto& [types, placement] : entries_) {
      if (types.empty()) {
        placements.push_back(placement);
        --remaining[static_cast<std::size_t>(placement.type)];
        pallet.place(placement);  // throws when the session took something invalid
      }
      for (const int type : types) {
        --remaining[static_cast<std::size_t>(type)];
        ++discarded[static_cast<std::size_t>(type)];
      }
    }
    ASSERT_EQ(session.remaining(), remaining) << "seed 81, run " << run;
    ASSERT_EQ(session.discarded(), discarded) << "seed 81, run " << run;
    ASSERT_EQ(session.pallet()->placements(), placements) << "seed 81, run " << run;
    ASSERT_EQ(session.pallet()->spaces(), pallet.spaces()) << "seed 81, run " << run;
  }

 private:
  struct Entry {
    std::vector<int> types;  ///< discarded; empty = placed
    Placement placement;
  };
  packing::Order order_;
  std::vector<Entry> entries_;
};

std::vector<int> someRemaining(const std::vector<int>& remaining, std::mt19937_64& rng) {
  std::vector<int> items;
  for (std::size_t i = 0; i < remaining.size(); ++i) {
    items.insert(items.end(), static_cast<std::size_t>(remaining[i]), static_cast<int>(i));
  }
  std::shuffle(items.begin(), items.end(), rng);
  items.resize(std::min<std::size_t>(items.size(), 3));
  return items;
}

TEST(PalletSession, randomDialoguesLoseAndDoubleNothing) {
  std::mt19937_64 rng(81);
  for (int run = 0; run < 80; ++run) {
    const packing::Order order = test::randomOrder(rng);
    PalletSession session(dblf());
    ASSERT_TRUE(session.start("p", order, false).ok());
    Ledger ledger(order);
    std::vector<std::uint64_t> current;   // decisions that can still be reported
    std::vector<std::uint64_t> stale{0};  // those that something was reported after
    std::vector<int> available;
    ChooseReply reply;
    for (int step = 0; step < 120; ++step) {
      const std::uint64_t revision = session.revision();
      switch (test::draw(rng, 0, 7)) {
        case 0:
        case 1:
        case 2:
          available = someRemaining(session.remaining(), rng);
          reply =
              session.choose(test::draw(rng, 0, 1) == 0 ? "" : "r" + std::to_string(step), available, kNever);
          EXPECT_EQ(session.revision(), revision);
          break;
        case 3:
        case 4:
          if (session.report(reply.decision_id, PickOutcome::kPlaced, {}, {}).ok() &&
              session.revision() > revision) {
            ledger.placed(reply.decision.options[*reply.decision.chosen].placement);
          }
          break;
        case 5:
          if (session.report(reply.decision_id, PickOutcome::kDiscarded, {}, {0}).ok() &&
              session.revision() > revision) {
            ledger.discarded({available[0]});
          }
          break;
        case 6: {
          const auto outcome = static_cast<PickOutcome>(test::draw(rng, 0, 2));
          session.report(stale[rng() % stale.size()], outcome, {}, {});
          EXPECT_EQ(session.revision(), revision) << "a stale report changed something";
          break;
        }
        default:
          EXPECT_EQ(session.undoLast().ok(), ledger.undo());
      }
      current.push_back(reply.decision_id);
      if (session.revision() > revision) {
        stale.insert(stale.end(), current.begin(), current.end());
        current.clear();
      }
      ledger.expectSame(session, run);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SessionState, theEventsRestoreTheState) {
  SessionState state;
  const packing::Order order = smallOrder();
  EXPECT_THROW(state.apply(LastUndone{}), std::invalid_argument);
  EXPECT_THROW(state.apply(PickReported{}), std::invalid_argument);
  EXPECT_THROW(state.apply(PalletClosed{}), std::invalid_argument);
  state.apply(PalletStarted{"p", order});
  EXPECT_THROW(state.apply(PalletStarted{"q", order}), std::invalid_argument);
  PickDecided decided{"r", {0}, {}, {}, 1.0};
  EXPECT_THROW(state.apply(decided), std::invalid_argument);  // decision 0
  decided.reply.decision_id = 1;
  EXPECT_THROW(state.apply(decided), std::invalid_argument);  // no options
  decided.reply.decision.options.resize(1);
  decided.reply.decision.options[0] = {true, {0, {0, 0, 0}, {100, 100, 100}}, {}, {}, ""};
  decided.reply.decision.chosen = 0;
  state.apply(decided);
  ASSERT_NE(state.decision(1), nullptr);
  PickReported reported{1, PickOutcome::kPlaced, Placement{0, {0, 0, 50}, {100, 100, 100}}, {}};
  EXPECT_THROW(state.apply(reported), std::invalid_argument);  // floats
  EXPECT_EQ(state.open()->remaining, order.counts);
  reported.measured.reset();
  state.apply(reported);
  EXPECT_EQ(state.open()->remaining, (std::vector<int>{3, 2}));
  EXPECT_NE(state.report(1), nullptr);
  EXPECT_EQ(state.nextDecisionId(), 2U);
}

TEST(StatusWords, areThoseOfTheInterface) {
  EXPECT_STREQ(toString(ChooseStatus::kNoneFits), "NONE_FITS");
  EXPECT_STREQ(toString(ChooseStatus::kOrderComplete), "ORDER_COMPLETE");
  EXPECT_STREQ(toString(SessionStatus::kPalletOpen), "PALLET_OPEN");
  EXPECT_STREQ(toString(SessionStatus::kNothingToUndo), "NOTHING_TO_UNDO");
}

}  // namespace
}  // namespace mixed_palletizing::planning
