#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <mixed_palletizing/planning/journal_export.hpp>
#include <mixed_palletizing/planning/pallet_journal.hpp>
#include <mixed_palletizing/planning/pallet_session.hpp>

#include "journal_support.hpp"
#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

namespace fs = std::filesystem;

using test::act;
using test::bytesOf;
using test::dblf;
using test::digest;
using test::kKeep;
using test::Recorded;

class Journal : public ::testing::Test {
 protected:
  Journal() { fs::create_directories(folder_); }
  ~Journal() override { fs::remove_all(folder_); }

  const fs::path folder_ = fs::path(::testing::TempDir()) / ("journal_" + std::to_string(::getpid()));
  const std::string path_ = (folder_ / "sub" / "p.journal").string();
};

TEST_F(Journal, theSessionGoesOnWhereItWas) {
  std::mt19937_64 rng(91);
  std::string before;
  for (int run = 0; run < 12; ++run) {
    Recorded recorded(path_);
    EXPECT_EQ(digest(recorded.session), run == 0 ? "0  " : before) << "seed 91, run " << run;
    for (int i = 0; i < 25; ++i) act(recorded.session, rng);
    before = digest(recorded.session);
  }
}

TEST_F(Journal, aRestoredDecisionIsAnsweredAndReportedAsBefore) {
  packing::Order order;
  order.rules.size = {300, 200, 200};
  order.types = {{"a", {100, 100, 100}, {}, 0, 0}, {"b", {200, 100, 100}, {}, 0, 0}};
  order.counts = {4, 1};
  const auto time_is_up = [] { return true; };
  ChooseReply first;
  {
    Recorded recorded(path_);
    ASSERT_TRUE(recorded.session.start("p", order, false).ok());
    first =
        recorded.session.choose("r", {0, 1}, time_is_up, 0.0, {{3, 5}, {{0.1, 0.1, 0.1}, {0.2, 0.1, 0.1}}});
  }
  Recorded recorded(path_);
  const ChooseReply again = recorded.session.choose("r", {0, 1}, {});
  EXPECT_EQ(again.decision_id, first.decision_id);
  EXPECT_EQ(again.decision.options[0].placement, first.decision.options[0].placement);
  EXPECT_TRUE(again.decision.options[0].looked_at);
  EXPECT_FALSE(again.decision.options[1].looked_at);
  ASSERT_TRUE(recorded.session.knownDecision(first.decision_id));
  EXPECT_EQ(recorded.session.knownDecision(first.decision_id)->notes.request_index,
            (std::vector<std::size_t>{3, 5}));
  EXPECT_TRUE(recorded.session.report(first.decision_id, PickOutcome::kPlaced, {}, {}).ok());
}

TEST_F(Journal, aSecondPlannerIsRefused) {
  const Recorded recorded(path_);
  try {
    const PalletJournal second(path_, kKeep);
    FAIL() << "two planners share a journal";
  } catch (const JournalError& error) {
    EXPECT_NE(std::string(error.what()).find("another planner"), std::string::npos) << error.what();
  }
}

TEST_F(Journal, keepsTheLastPalletsOnly) {
  std::mt19937_64 rng(93);
  Recorded recorded(path_);
  for (int i = 0; i < 10; ++i)
    ASSERT_TRUE(recorded.session.start("p" + std::to_string(i), test::randomOrder(rng), true).ok());
  const std::vector<JournalEntry> entries = readJournal(path_);  // while it is open
  EXPECT_EQ(entries.front().pallet, 8);
  EXPECT_EQ(entries.back().pallet, 10);
  EXPECT_NE(palletList(entries).find("  p9  "), std::string::npos);
  EXPECT_THROW(entriesOf(entries, "p1"), std::invalid_argument);
  const std::string json = palletJson(entriesOf(entries, "p8"));
  EXPECT_NE(json.find("\"pallet_id\": \"p8\""), std::string::npos) << json;
  EXPECT_NE(palletHistory(entriesOf(entries, "")).find("started 'p9'"), std::string::npos);
}

/// Plays in a child process until it is killed; tells over a pipe the revision and the digest of every state
/// that was answered.
[[noreturn]] void playUntilKilled(const std::string& path, std::uint64_t seed, int pipe_end) {
  std::mt19937_64 rng(seed);
  Recorded recorded(path);
  while (true) {
    act(recorded.session, rng);
    const std::string line = digest(recorded.session) + '\n';
    if (::write(pipe_end, line.data(), line.size()) < 0) ::_exit(1);
  }
}

std::string lastLine(int pipe_end) {
  std::string all;
  char buffer[4096];
  for (ssize_t n = 0; (n = ::read(pipe_end, buffer, sizeof buffer)) > 0;)
    all.append(buffer, static_cast<std::size_t>(n));
  if (all.empty() || all.back() != '\n') all.erase(all.find_last_of('\n') + 1);
  if (all.empty()) return "";
  const std::size_t begin = all.find_last_of('\n', all.size() - 2);
  return all.substr(begin == std::string::npos ? 0 : begin + 1,
                    all.size() - 1 - (begin == std::string::npos ? 0 : begin + 1));
}

TEST_F(Journal, survivesKillsAtRandomInstants) {
  std::mt19937_64 rng(94);
  int with_answers = 0;
  std::string last_known;
  // On a slow disk a child has to live longer before it has been answered.
  for (int run = 0; run < 220 || (with_answers <= 100 && run < 1100); ++run) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const std::uint64_t seed = rng();
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::close(ends[0]);
      playUntilKilled(path_, seed, ends[1]);
    }
    ::close(ends[1]);
    std::this_thread::sleep_for(std::chrono::microseconds(test::draw(rng, 0, 40000 * (1 + run / 220))));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself: seed 94, run " << run;
    const std::string answered = lastLine(ends[0]);
    ::close(ends[0]);
    if (!answered.empty()) {
      last_known = answered;
      ++with_answers;
    }
    const PalletJournal journal(path_, kKeep);
    const PalletSession session(dblf(), journal.restore());
    // The journal may be one change ahead of the last answer, never behind it.
    const std::string restored = digest(session);
    if (restored == last_known) continue;
    const std::uint64_t known_revision = last_known.empty() ? 0 : std::stoull(last_known);
    EXPECT_GE(session.revision(), known_revision) << "seed 94, run " << run;
    EXPECT_LE(session.revision(), known_revision + 2) << "seed 94, run " << run;
    last_known = restored;
  }
  EXPECT_GT(with_answers, 100);
}

class DamagedJournal : public Journal {
 protected:
  void SetUp() override {
    std::mt19937_64 rng(95);
    Recorded recorded(path_);
    for (int i = 0; i < 60; ++i) act(recorded.session, rng);
    whole_ = digest(recorded.session);
  }

  /// What a copy with this content opens as; std::nullopt when it is refused.
  std::optional<std::string> openedAs(const std::string& content) {
    const std::string copy = (folder_ / "copy.journal").string();
    for (const char* end : {"", "-wal", "-shm"}) fs::remove(copy + end);
    std::ofstream(copy, std::ios::binary) << content;
    fs::copy_file(path_ + ".lock", copy + ".lock", fs::copy_options::overwrite_existing);
    try {
      const PalletJournal journal(copy, kKeep);
      return digest(PalletSession(dblf(), journal.restore()));
    } catch (const JournalError& error) {
      EXPECT_NE(std::string(error.what()).find("move it"), std::string::npos) << error.what();
      return std::nullopt;
    }
  }

  std::string whole_;
};

TEST_F(DamagedJournal, isRefusedWhenCutOff) {
  const std::string content = bytesOf(path_);
  EXPECT_EQ(openedAs(content), whole_);
  std::mt19937_64 rng(96);
  for (int run = 0; run < 60; ++run) {
    const auto length = static_cast<std::size_t>(rng() % content.size());
    EXPECT_FALSE(openedAs(content.substr(0, length))) << "seed 96, run " << run << ", " << length << " bytes";
  }
  EXPECT_FALSE(openedAs(""));
  EXPECT_FALSE(openedAs("no database"));
}

TEST_F(DamagedJournal, isRefusedOrWholeWhenBitsAreFlipped) {
  const std::string content = bytesOf(path_);
  std::mt19937_64 rng(97);
  int refused = 0;
  for (int run = 0; run < 300; ++run) {
    std::string flipped = content;
    const auto at = static_cast<std::size_t>(rng() % content.size());
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (rng() % 8)));
    const std::optional<std::string> opened = openedAs(flipped);
    EXPECT_EQ(opened.value_or(whole_), whole_) << "seed 97, run " << run << ", byte " << at;
    refused += opened ? 0 : 1;
  }
  EXPECT_GT(refused, 100);  // the rest hit room that is not in use
}

TEST_F(Journal, refusesBadInput) {
  EXPECT_THROW(readJournal((folder_ / "none.journal").string()), JournalError);
  EXPECT_THROW(PalletJournal(path_, 0), std::invalid_argument);
  std::ofstream(folder_ / "file") << "x";
  EXPECT_THROW(PalletJournal((folder_ / "file" / "p.journal").string(), kKeep), JournalError);
}

}  // namespace
}  // namespace mixed_palletizing::planning
