#include "playout_race.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include <mixed_palletizing/packing/random.hpp>
#include <mixed_palletizing/planning/in_parallel.hpp>

#include "future_value.hpp"

namespace mixed_palletizing::planning {
namespace {

constexpr int kRoundsBetweenDrops = 8;
constexpr double kStandardErrorsBehind = 2.5;
/// Rounds without a single loss of any runner after which the race is called off.
constexpr std::size_t kSureRounds = 128;

}  // namespace

PlayoutRace::PlayoutRace(const Situation& situation, const std::vector<ScoredPlacement>& pairs,
                         std::vector<Playout>& engines, std::uint64_t seed)
    : engines_(engines), random_(seed) {
  std::vector<int> visible(situation.types.size(), 0);
  for (const int type : situation.available) ++visible[static_cast<std::size_t>(type)];
  for (std::size_t t = 0; t < visible.size(); ++t) {
    to_come_.insert(to_come_.end(), static_cast<std::size_t>(situation.remaining[t] - visible[t]),
                    static_cast<int>(t));
  }
  for (const ScoredPlacement& pair : pairs) {
    Runner runner{
        pair.placement,
        {situation.pallet, visible, situation.remaining, static_cast<int>(situation.available.size())},
        {},
        true};
    runner.start.pallet.place(pair.placement);
    --runner.start.visible[static_cast<std::size_t>(pair.placement.type)];
    --runner.start.remaining[static_cast<std::size_t>(pair.placement.type)];
    runners_.push_back(std::move(runner));
  }
}

void PlayoutRace::run(int samples, const packing::StopCallback& stop) {
  for (int round = 0; round < samples; round += kRoundsBetweenDrops) {
    if (!playRounds(std::min(kRoundsBetweenDrops, samples - round), stop)) return;
    dropThoseBehind();
    const auto racing =
        std::count_if(runners_.begin(), runners_.end(), [](const Runner& runner) { return runner.racing; });
    if (racing < 2 || nothingToLearn()) return;
  }
}

/// False when stopped; the rounds that were completed count.
bool PlayoutRace::playRounds(int rounds, const packing::StopCallback& stop) {
  std::vector<std::size_t> racing;
  for (std::size_t i = 0; i < runners_.size(); ++i) {
    if (runners_[i].racing) racing.push_back(i);
  }
  std::vector<std::vector<int>> arrivals;
  for (int i = 0; i < rounds; ++i) {
    packing::shuffle(to_come_, random_);
    arrivals.push_back(to_come_);
  }
  std::vector<std::optional<PlayoutEnd>> ends(arrivals.size() * racing.size());
  std::atomic<bool> stopped{false};
  inParallel(ends.size(), static_cast<int>(engines_.size()), [&](std::size_t worker, std::size_t i) {
    if (stopped) return;
    const Runner& runner = runners_[racing[i % racing.size()]];
    ends[i] = engines_[worker].play(runner.start, arrivals[i / racing.size()], stop);
    if (!ends[i]) stopped = true;
  });
  for (std::size_t first = 0; first < ends.size(); first += racing.size()) {
    const auto at = [&ends](std::size_t i) { return ends.begin() + static_cast<std::ptrdiff_t>(i); };
    if (std::find(at(first), at(first + racing.size()), std::nullopt) != at(first + racing.size())) break;
    for (std::size_t i = 0; i < racing.size(); ++i) runners_[racing[i]].ends.push_back(*ends[first + i]);
  }
  return !stopped;
}

/// Drops every runner that is clearly behind the leader; futures are the same, so differences are paired.
void PlayoutRace::dropThoseBehind() {
  const Runner& best = runners_[leader()];
  const auto n = static_cast<double>(best.ends.size());
  for (Runner& runner : runners_) {
    if (!runner.racing) continue;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < best.ends.size(); ++i) {
      const double behind = value(best.ends[i]) - value(runner.ends[i]);
      sum += behind;
      squares += behind * behind;
    }
    const double mean = sum / n;
    const double variance = std::max(0.0, squares / n - mean * mean);
    if (mean > kStandardErrorsBehind * std::sqrt(variance / n)) runner.racing = false;
  }
}

bool PlayoutRace::nothingToLearn() const {
  return std::all_of(runners_.begin(), runners_.end(), [](const Runner& runner) {
    return !runner.racing || (runner.ends.size() >= kSureRounds &&
                              std::all_of(runner.ends.begin(), runner.ends.end(),
                                          [](const PlayoutEnd& e) { return e.perfect(); }));
  });
}

std::size_t PlayoutRace::leader() const {
  std::size_t best = 0;
  while (!runners_[best].racing) ++best;
  for (std::size_t i = best + 1; i < runners_.size(); ++i) {
    if (runners_[i].racing && meanValue(runners_[i]) > meanValue(runners_[best])) best = i;
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
