#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <utility>

#include <mixed_palletizing/planning/ponderer.hpp>

#include "candidates.hpp"

namespace mixed_palletizing::planning {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLookAtStop{1};

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

PlannerOptions inOneThread(PlannerOptions options) {
  options.best.threads = 1;
  return options;
}

std::vector<int> sorted(std::vector<int> items) {
  std::sort(items.begin(), items.end());
  return items;
}

/// The decision for other available items of the same types in another sequence.
Decision resequenced(const Decision& decision, const std::vector<int>& from, const std::vector<int>& to) {
  Decision other;
  other.fitted = decision.fitted;
  const auto indexIn = [&from](int type) {
    return static_cast<std::size_t>(std::find(from.begin(), from.end(), type) - from.begin());
  };
  for (std::size_t i = 0; i < to.size(); ++i) {
    const std::size_t first = firstOfType(to, i);
    other.options.push_back(first < i ? other.options[first] : decision.options[indexIn(to[i])]);
  }
  if (decision.chosen) {
    const auto chosen = std::find(to.begin(), to.end(), from[*decision.chosen]);
    other.chosen = static_cast<std::size_t>(chosen - to.begin());
  }
  return other;
}

}  // namespace

/// A world and what is thought of it. Guarded by the ponderer's mutex, but for the flags and the world.
struct Ponderer::Thought {
  const ExpectedWorld world;
  const double budget_ms;
  std::atomic<bool> cancelled{false};
  std::atomic<bool> awaited{false};  ///< its own budget does not end it any more
  bool begun = false;
  bool done = false;
  bool cut = false;  ///< ended by its budget or its taker, not by itself
  double thought_ms = 0.0;
  std::optional<Decision> decision;  ///< none: a fault

  Thought(ExpectedWorld w, double ms) : world(std::move(w)), budget_ms(ms) {}

  std::optional<Decision> think(const PlannerOptions& options) {
    const Clock::time_point start = Clock::now();
    const bool to_its_end = options.best.samples > 0;
    const auto stop = [&] {
      cut = cut || cancelled || (!to_its_end && !awaited && millisecondsSince(start) >= budget_ms);
      return cut;
    };
    std::optional<Decision> found;
    try {
      found = chooseNextPick(world.situation(), options, world.seed, stop);
    } catch (const std::exception&) {
      // Whoever asks is answered without it, and told of the fault.
    }
    thought_ms = millisecondsSince(start);
    return found;
  }
};

Ponderer::Ponderer(const PlannerOptions& options)
    : options_(inOneThread(options)), others_think_faster_(options.best.threads > 1) {
  if (options.method == PlanMethod::kBest) thread_ = std::thread([this] { run(); });
}

Ponderer::~Ponderer() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    quit_ = true;
    drop();
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Ponderer::drop() {
  for (const auto& thought : thoughts_) thought->cancelled = true;
  thoughts_.clear();
}

void Ponderer::forget() { expect({}, 0.0); }

void Ponderer::expect(std::vector<ExpectedWorld> worlds, double budget_ms,
                      const std::optional<PolicyWeights>& fitted) {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    drop();
    fitted_ = fitted;
    for (ExpectedWorld& world : worlds) {
      thoughts_.push_back(std::make_shared<Thought>(std::move(world), budget_ms));
    }
  }
  changed_.notify_all();
}

void Ponderer::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!quit_) {
    const auto next =
        std::find_if(thoughts_.begin(), thoughts_.end(), [](const auto& thought) { return !thought->begun; });
    if (next == thoughts_.end()) {
      changed_.wait(lock);
      continue;
    }
    const std::shared_ptr<Thought> thought = *next;
    thought->begun = true;
    PlannerOptions options = options_;
    options.best.fitted = fitted_;
    lock.unlock();
    std::optional<Decision> decision = thought->think(options);
    lock.lock();
    const bool of_this_order = !thought->cancelled || thought->awaited;
    if (of_this_order && decision && decision->fitted) fitted_ = decision->fitted;
    thought->decision = std::move(decision);
    thought->done = true;
    changed_.notify_all();
  }
}

std::optional<PolicyWeights> Ponderer::fitted() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return fitted_;
}

std::shared_ptr<Ponderer::Thought> Ponderer::find(const Situation& situation, std::uint64_t seed) const {
  const std::vector<int> available = sorted(situation.available);
  const auto found = std::find_if(thoughts_.begin(), thoughts_.end(), [&](const auto& thought) {
    const ExpectedWorld& world = thought->world;
    return world.seed == seed && world.remaining == situation.remaining &&
           world.forecast == situation.forecast && sorted(world.available) == available &&
           world.pallet->placements() == situation.pallet.placements();
  });
  return found == thoughts_.end() ? nullptr : *found;
}

std::optional<Decision> Ponderer::take(const Situation& situation, std::uint64_t seed, double budget_ms,
                                       const packing::StopCallback& stop) {
  if (!thread_.joinable()) return std::nullopt;
  std::unique_lock<std::mutex> lock(mutex_);
  // Without any limit of time a decision is a certain number of futures, which was not counted here.
  const bool countable = stop || options_.best.samples > 0;
  const std::shared_ptr<Thought> thought = countable ? find(situation, seed) : nullptr;
  if (thought && thought->begun && !thought->done && !others_think_faster_) {
    thought->awaited = true;
    while (!thought->done) {
      changed_.wait_for(lock, kLookAtStop);
      if (thought->done || !stop || !stop()) continue;
      thought->cancelled = true;
      budget_ms = 0.0;  // it has had all the time there is
    }
  }
  drop();
  if (!thought || !thought->done || !thought->decision) return std::nullopt;
  if (thought->cut && thought->thought_ms < budget_ms) return std::nullopt;
  return resequenced(*thought->decision, thought->world.available, situation.available);
}

}  // namespace mixed_palletizing::planning
