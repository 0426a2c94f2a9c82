// A session with a journal, worked at random.
#pragma once

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <mixed_palletizing/planning/pallet_journal.hpp>
#include <mixed_palletizing/planning/pallet_session.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning::test {

constexpr int kKeep = 3;  ///< pallets

inline PlannerOptions dblf() {
  PlannerOptions options;
  options.method = PlanMethod::kDblf;
  return options;
}

/// A session that records in a journal.
struct Recorded {
  explicit Recorded(const std::string& path)
      : journal(path, kKeep),
        session(dblf(), journal.restore(),
                [this](const auto& before, const auto& events) { journal.append(before, events); }) {}
  PalletJournal journal;
  PalletSession session;
};

/// Everything a session answers, as one text.
inline std::string digest(const PalletSession& session) {
  std::ostringstream text;
  text << session.revision() << ' ' << session.palletId() << ' ';
  if (!session.open()) return text.str();
  for (const packing::Placement& p : session.pallet()->placements()) {
    text << p.type << ',' << p.origin.x << ',' << p.origin.y << ',' << p.origin.z << ',' << p.size.x << ' ';
  }
  for (const int count : session.remaining()) text << count << ' ';
  for (const int count : session.discarded()) text << count << ' ';
  if (const PickDecided* pending = session.pendingDecision()) {
    text << pending->reply.decision_id << pending->request_id << pending->reply.message;
  }
  return text.str();
}

/// One random request of a robot.
inline void act(PalletSession& session, std::mt19937_64& rng) {
  if (!session.open()) {
    session.start("p" + std::to_string(rng() % 1000), randomOrder(rng), false);
    return;
  }
  const PickDecided* pending = session.pendingDecision();
  const int what = draw(rng, 0, 19);
  if (what == 0) {
    session.undoLast();
  } else if (what == 1) {
    PalletSummary summary;
    session.close(summary);
  } else if (what == 2) {
    session.start("q", randomOrder(rng), true);
  } else if (pending != nullptr) {
    const auto outcome = what < 5 || !pending->reply.decision.chosen ? PickOutcome::kDiscarded
                         : what < 7                                  ? PickOutcome::kFailed
                                                                     : PickOutcome::kPlaced;
    session.report(pending->reply.decision_id, outcome, {}, {});
  } else {
    std::vector<int> available;
    const std::vector<int> remaining = session.remaining();
    for (std::size_t t = 0; t < remaining.size() && available.size() < 3; ++t) {
      if (remaining[t] > 0) available.push_back(static_cast<int>(t));
    }
    if (available.empty()) {
      PalletSummary summary;
      session.close(summary);
    } else {
      session.choose(std::to_string(rng() % 10), available, {});
    }
  }
}

inline std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace mixed_palletizing::planning::test
