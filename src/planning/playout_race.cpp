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

constexpr int kRoundsBetweenDrops = 8;  ///< at least; later an eighth of those played
constexpr double kStandardErrorsBehind = 2.5;
/// Rounds without any difference between the runners after which the race is called off.
constexpr int kSureRounds = 128;

}  // namespace

PlayoutRace::PlayoutRace(const Situation& situation, const std::vector<ScoredPlacement>& pairs,
                         std::vector<Playout>& engines, std::uint64_t seed)
    : engines_(engines), random_(seed), forecast_(situation.forecast) {
  std::vector<int> visible(situation.types.size(), 0);
  for (const int type : situation.available) ++visible[static_cast<std::size_t>(type)];
  for (std::size_t t = 0; t < visible.size(); ++t) {
    to_come_.insert(to_come_.end(), static_cast<std::size_t>(situation.remaining[t] - visible[t]),
                    static_cast<int>(t));
  }
  for (const ScoredPlacement& pair : pairs) {
    Runner runner{
        pair.placement, {situation.pallet, visible, static_cast<int>(situation.available.size())}, {}, true};
    runner.start.pallet.place(pair.placement);
    --runner.start.visible[static_cast<std::size_t>(pair.placement.type)];
    runners_.push_back(std::move(runner));
  }
}

void PlayoutRace::run(int samples, const packing::StopCallback& stop) {
  const int rounds = onlyOneFuture() ? 1 : samples;
  for (int done = 0; done < rounds;) {
    const int next = std::min(std::max(kRoundsBetweenDrops, done / kRoundsBetweenDrops), rounds - done);
    if (!playRounds(next, stop)) return;
    done += next;
    dropThoseBehind();
    const auto racing =
        std::count_if(runners_.begin(), runners_.end(), [](const Runner& runner) { return runner.racing; });
    if (racing < 2 || (done >= kSureRounds && noDifference())) return;
  }
}

/// All that is to come is of one type: there is nothing to draw.
bool PlayoutRace::onlyOneFuture() const {
  const bool alike = to_come_.empty() || to_come_.front() == to_come_.back();  // sorted still
  return alike && std::all_of(forecast_.begin(), forecast_.end(), [](double count) { return count == 0.0; });
}

/// What may come, in a random order: the items known, and of every type with a forecast a number drawn from the
/// Poisson distribution: the arrivals of a stream in the time that brings so many in the mean.
std::vector<int> PlayoutRace::drawArrival() {
  const auto gap = [this] { return -std::log(1.0 - packing::uniform01(random_)); };
  std::vector<int> arrival = to_come_;
  for (std::size_t t = 0; t < forecast_.size(); ++t) {
    for (double time = gap(); time < forecast_[t]; time += gap()) arrival.push_back(static_cast<int>(t));
  }
  packing::shuffle(arrival, random_);
  return arrival;
}

/// False when stopped; the rounds that were completed count.
bool PlayoutRace::playRounds(int rounds, const packing::StopCallback& stop) {
  std::vector<std::size_t> racing;
  for (std::size_t i = 0; i < runners_.size(); ++i) {
    if (runners_[i].racing) racing.push_back(i);
  }
  std::vector<std::vector<int>> arrivals;
  for (int i = 0; i < rounds; ++i) {
    arrivals.push_back(drawArrival());
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
