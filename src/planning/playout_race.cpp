#include "playout_race.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <mixed_palletizing/packing/in_parallel.hpp>

#include "future_value.hpp"

namespace mixed_palletizing::planning {
namespace {

constexpr std::size_t kRoundsBetweenDrops = 8;  ///< at least; later an eighth of those played
constexpr std::size_t kMostRoundsAtOnce = 1024;
constexpr double kStandardErrorsBehind = 2.5;
/// Rounds after which pairs that were rated lower may enter: before, the time is better spent on the first.
constexpr std::size_t kSettledRounds = 32;
/// ... and after each so many rounds one: the first keep the larger part of the time.
constexpr std::size_t kRoundsPerEntry = 4;
/// Rounds of the leader, nothing left over in any of them, after which the race is decided.
constexpr std::size_t kSureRounds = 64;
/// Rounds without any difference between the runners after which the race is called off.
constexpr std::size_t kEqualRounds = 128;
/// So many are left at the end of a halving, or one more: the leader before it.
constexpr std::size_t kFinalists = 2;

}  // namespace

PlayoutRace::PlayoutRace(const Situation& situation, const std::vector<ScoredPlacement>& pairs, int lanes,
                         std::vector<Playout>& engines, const SampledFutures& futures)
    : pairs_(pairs),
      lanes_(static_cast<std::size_t>(lanes)),
      engines_(engines),
      futures_(futures),
      start_(playoutStart(situation)) {
  while (runners_.size() < std::min(lanes_, pairs_.size())) enter();
}

void PlayoutRace::enter() {
  Runner runner{pairs_[runners_.size()].placement, start_, {}, true};
  runner.start.pallet.place(runner.placement);
  --runner.start.visible[static_cast<std::size_t>(runner.placement.type)];
  runners_.push_back(std::move(runner));
}

/// False when there is no free lane or no further pair.
bool PlayoutRace::enterMore(std::size_t most) {
  std::size_t taken =
      static_cast<std::size_t>(std::count_if(runners_.begin(), runners_.end(), [most](const Runner& runner) {
        return runner.racing && runner.ends.size() < most;
      }));
  bool entered = false;
  for (; taken < lanes_ && runners_.size() < pairs_.size(); ++taken) {
    enter();
    entered = true;
  }
  return entered;
}

void PlayoutRace::run(std::optional<int> samples, const packing::StopCallback& stop) {
  const std::size_t most = futures_.onlyOne() ? 1
                           : samples          ? static_cast<std::size_t>(*samples)
                                              : std::numeric_limits<std::size_t>::max();
  const bool others_enter = lanes_ > 1 && (!samples || most == 1);
  while (true) {
    const std::size_t lead = runners_[leader()].ends.size();
    const std::size_t least = fewestEnds();
    std::size_t step = std::max(kRoundsBetweenDrops, least);  // of those who catch up
    if (least == lead) {
      if (certain()) return;
      const std::size_t entered = runners_.size() - std::min(lanes_, pairs_.size());
      const bool due = lead >= kSettledRounds && entered < lead / kRoundsPerEntry;
      if (others_enter && (due || racing() < 2 || lead >= most) && enterMore(most)) continue;
      if (lead >= most || racing() < 2 || (lead >= kEqualRounds && noDifference())) return;
      step = std::max(kRoundsBetweenDrops, lead / kRoundsBetweenDrops);
    }
    const std::size_t goal = least + std::min(step, kMostRoundsAtOnce);
    if (!playUntil(std::min(goal, least < lead ? lead : most), stop)) return;
    dropThoseBehind();
  }
}

void PlayoutRace::halve(std::size_t pairs, std::size_t futures, const packing::StopCallback& stop) {
  const std::size_t first = leader();
  const std::size_t lead = runners_[first].ends.size();
  while (runners_.size() < std::min(pairs, pairs_.size())) {
    if (stop && stop()) return;  // every one is a copy of the pallet
    enter();
  }
  for (Runner& runner : runners_) runner.racing = true;
  for (std::size_t rounds = futures;; rounds *= 2) {
    if (!catchUp(rounds, stop)) return;
    if (racing() <= kFinalists + 1 && rounds >= lead) return;
    dropWorseHalf(rounds, first);
  }
}

/// As playUntil(), whatever number they played before.
bool PlayoutRace::catchUp(std::size_t rounds, const packing::StopCallback& stop) {
  while (true) {
    const std::size_t fewest = fewestEnds();
    if (fewest >= rounds) return true;
    std::size_t next = std::min(rounds, fewest + kMostRoundsAtOnce);
    for (const Runner& runner : runners_) {
      if (runner.racing && runner.ends.size() > fewest) next = std::min(next, runner.ends.size());
    }
    if (!playUntil(next, stop)) return false;
  }
}

/// By their first `rounds` futures; `kept` stays.
void PlayoutRace::dropWorseHalf(std::size_t rounds, std::size_t kept) {
  const auto ratedBy = [&](std::size_t i) {
    double sum = 0.0;
    for (std::size_t future = 0; future < rounds; ++future) sum += value(runners_[i].ends[future]);
    return sum;
  };
  std::vector<std::pair<double, std::size_t>> rated;
  for (std::size_t i = 0; i < runners_.size(); ++i) {
    if (runners_[i].racing) rated.emplace_back(-ratedBy(i), i);
  }
  std::sort(rated.begin(), rated.end());
  const std::size_t left = std::max(kFinalists, (rated.size() + 1) / 2);
  for (std::size_t i = left; i < rated.size(); ++i) {
    if (rated[i].second != kept) runners_[rated[i].second].racing = false;
  }
}

/// Nothing can be better than a leader that always became perfect.
bool PlayoutRace::certain() const {
  const std::vector<PlayoutEnd>& ends = runners_[leader()].ends;
  const std::size_t needed = futures_.onlyOne() ? 1 : kSureRounds;
  return ends.size() >= needed &&
         std::all_of(ends.begin(), ends.end(), [](const PlayoutEnd& end) { return end.perfect(); });
}

std::size_t PlayoutRace::racing() const {
  return static_cast<std::size_t>(
      std::count_if(runners_.begin(), runners_.end(), [](const Runner& runner) { return runner.racing; }));
}

/// Of those racing.
std::size_t PlayoutRace::fewestEnds() const {
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const Runner& runner : runners_) {
    if (runner.racing) fewest = std::min(fewest, runner.ends.size());
  }
  return fewest;
}

/// Those racing with fewer futures than `rounds` play up to so many; they all played the same number before. False
/// when stopped; the rounds that all of them completed count.
bool PlayoutRace::playUntil(std::size_t rounds, const packing::StopCallback& stop) {
  std::vector<std::size_t> players;
  for (std::size_t i = 0; i < runners_.size(); ++i) {
    if (runners_[i].racing && runners_[i].ends.size() < rounds) players.push_back(i);
  }
  const std::size_t done = runners_[players.front()].ends.size();
  std::vector<std::vector<int>> arrivals;
  for (std::size_t future = done; future < rounds; ++future) {
    if (stop && stop()) break;  // of many boxes each draw takes its time
    arrivals.push_back(futures_.arrival(future));
  }
  if (arrivals.empty()) return false;
  std::vector<std::optional<PlayoutEnd>> ends(arrivals.size() * players.size());
  std::atomic<bool> stopped{false};
  packing::inParallel(ends.size(), static_cast<int>(engines_.size()), [&](std::size_t worker, std::size_t i) {
    if (stopped) return;
    const Runner& runner = runners_[players[i % players.size()]];
    ends[i] = engines_[worker].play(runner.start, arrivals[i / players.size()], stop);
    if (!ends[i]) stopped = true;
  });
  for (std::size_t first = 0; first < ends.size(); first += players.size()) {
    const auto at = [&ends](std::size_t i) { return ends.begin() + static_cast<std::ptrdiff_t>(i); };
    if (std::find(at(first), at(first + players.size()), std::nullopt) != at(first + players.size())) break;
    for (std::size_t i = 0; i < players.size(); ++i) runners_[players[i]].ends.push_back(*ends[first + i]);
  }
  return !stopped;
}

/// Drops every runner that is clearly behind the leader; futures are the same, so differences are paired.
void PlayoutRace::dropThoseBehind() {
  const Runner& best = runners_[leader()];
  for (Runner& runner : runners_) {
    if (!runner.racing || runner.ends.empty()) continue;
    const auto n = static_cast<double>(runner.ends.size());
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < runner.ends.size(); ++i) {
      const double behind = value(best.ends[i]) - value(runner.ends[i]);
      sum += behind;
      squares += behind * behind;
    }
    const double mean = sum / n;
    const double variance = std::max(0.0, squares / n - mean * mean);
    if (mean > kStandardErrorsBehind * std::sqrt(variance / n)) runner.racing = false;
  }
}

bool PlayoutRace::noDifference() const {
  const Runner& best = runners_[leader()];
  return std::all_of(runners_.begin(), runners_.end(), [&](const Runner& runner) {
    return !runner.racing ||
           std::equal(runner.ends.begin(), runner.ends.end(), best.ends.begin(), best.ends.end(),
                      [this](const PlayoutEnd& a, const PlayoutEnd& b) { return value(a) == value(b); });
  });
}

std::size_t PlayoutRace::leader() const {
  std::size_t best = 0;
  while (!runners_[best].racing) ++best;
  double best_value = meanValue(runners_[best]);
  for (std::size_t i = best + 1; i < runners_.size(); ++i) {
    const std::size_t played = runners_[i].ends.size();
    if (!runners_[i].racing || played < runners_[best].ends.size()) continue;
    const double value = meanValue(runners_[i]);
    if (played == runners_[best].ends.size() && value <= best_value) continue;
    best = i;
    best_value = value;
  }
  return best;
}

double PlayoutRace::meanValue(const Runner& runner) const {
  if (runner.ends.empty()) return 0.0;
  double sum = 0.0;
  for (const PlayoutEnd& end : runner.ends) sum += value(end);
  return sum / static_cast<double>(runner.ends.size());
}

double PlayoutRace::value(const PlayoutEnd& end) const {
  return futureValue(end, engines_.front().policy().palletVolume());
}

}  // namespace mixed_palletizing::planning
