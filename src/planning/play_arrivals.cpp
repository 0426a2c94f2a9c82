// The rules of play: the first n_pick items of the arrival are available; after each placed box the next
// joins; when none of the available fits anywhere they are all discarded and the next n_pick arrive.
#include <algorithm>
#include <chrono>
#include <stdexcept>

#include <mixed_palletizing/planning/play_arrivals.hpp>

#include "known_order.hpp"

namespace mixed_palletizing::planning {
namespace {

using Clock = std::chrono::steady_clock;

/// One seed per decision (splitmix64, Steele, Lea and Flood 2014).
std::uint64_t decisionSeed(std::uint64_t seed, std::uint64_t decision) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL * (decision + 1);
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

void check(const packing::Order& order, const std::vector<int>& arrival, const PlayOptions& options) {
  std::vector<std::string> found = packing::problems(order);
  for (const std::string& problem : problems(options)) found.push_back("options: " + problem);
  if (!found.empty()) throw std::invalid_argument("playArrivals: " + found.front());
  std::vector<int> counts(order.types.size(), 0);
  for (const int type : arrival) {
    if (type < 0 || static_cast<std::size_t>(type) >= counts.size()) {
      throw std::invalid_argument("playArrivals: arrival: type " + std::to_string(type) + " of " +
                                  std::to_string(counts.size()) + " types");
    }
    ++counts[static_cast<std::size_t>(type)];
  }
  if (counts != order.counts) throw std::invalid_argument("playArrivals: arrival: is not the order's items");
}

class Play {
 public:
  Play(const packing::Order& order, const std::vector<int>& arrival, const PlayOptions& options)
      : order_(order),
        arrival_(arrival),
        options_(options),
        planner_(options.planner),
        pallet_(order),
        remaining_(order.counts) {
    arrive();
  }

  bool over() const { return available_.empty(); }

  /// One decision and what follows from it.
  void step() {
    Situation situation{pallet_, order_.types, {}, remaining_};
    for (const int item : available_) situation.available.push_back(typeOf(item));
    if (options_.knowledge == PlayKnowledge::kForecast) doubtCounts(situation);
    if (options_.knowledge == PlayKnowledge::kTypes) forgetCounts(situation);
    const Clock::time_point start = Clock::now();
    packing::StopCallback stop;
    if (options_.budget_ms > 0.0) {
      const auto deadline = start + std::chrono::duration<double, std::milli>(options_.budget_ms);
      stop = [deadline] { return Clock::now() >= deadline; };
    }
    const std::uint64_t seed = decisionSeed(options_.seed, result_.decision_ms.size());
    const Decision decision = chooseNextPick(situation, planner_, seed, stop);
    planner_.best.fitted = decision.fitted;
    result_.decision_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    if (decision.chosen) {
      place(*decision.chosen, decision.options[*decision.chosen].placement);
    } else {
      discardAll();
    }
  }

  int done() const { return static_cast<int>(result_.placements.size() + result_.unpacked.size()); }

  PlayResult takeResult() {
    result_.utilization = pallet_.utilization();
    return std::move(result_);
  }

 private:
  /// Leaves the available items sure; of the others as many are expected as come.
  static void doubtCounts(Situation& situation) {
    std::vector<int> sure(situation.types.size(), 0);
    for (const int type : situation.available) ++sure[static_cast<std::size_t>(type)];
    for (std::size_t t = 0; t < sure.size(); ++t)
      situation.forecast.push_back(situation.remaining[t] - sure[t]);
    situation.remaining = std::move(sure);
  }

  /// Leaves the available items and the types.
  void forgetCounts(Situation& situation) const {
    situation.remaining.assign(order_.types.size(), 0);
    auto free_volume = static_cast<double>(packing::volume(order_.rules.size) - pallet_.packedVolume());
    for (const int type : situation.available) {
      ++situation.remaining[static_cast<std::size_t>(type)];
      free_volume -= static_cast<double>(packing::volume(order_.types[static_cast<std::size_t>(type)].size));
    }
    const double share = std::max(0.0, free_volume) / static_cast<double>(order_.types.size());
    for (const packing::ItemType& type : order_.types) {
      situation.forecast.push_back(share / static_cast<double>(packing::volume(type.size)));
    }
  }

  int typeOf(int item) const { return arrival_[static_cast<std::size_t>(item)]; }

  void place(std::size_t chosen, const packing::Placement& placement) {
    pallet_.place(placement);
    result_.placements.push_back({available_[chosen], placement, available_});
    --remaining_[static_cast<std::size_t>(placement.type)];
    available_.erase(available_.begin() + static_cast<std::ptrdiff_t>(chosen));
    if (next_ < arrival_.size()) available_.push_back(static_cast<int>(next_++));
  }

  void discardAll() {
    for (const int item : available_) {
      result_.unpacked.push_back(item);
      --remaining_[static_cast<std::size_t>(typeOf(item))];
    }
    available_.clear();
    arrive();
  }

  void arrive() {
    while (available_.size() < static_cast<std::size_t>(options_.n_pick) && next_ < arrival_.size()) {
      available_.push_back(static_cast<int>(next_++));
    }
  }

  const packing::Order& order_;
  const std::vector<int>& arrival_;
  const PlayOptions& options_;
  PlannerOptions planner_;
  packing::PalletState pallet_;
  std::vector<int> remaining_;
  std::vector<int> available_;  ///< indices in the arrival
  std::size_t next_ = 0;
  PlayResult result_;
};

}  // namespace

std::optional<PlayKnowledge> playKnowledgeFromString(const std::string& word) {
  if (word == "set") return PlayKnowledge::kSet;
  if (word == "forecast") return PlayKnowledge::kForecast;
  if (word == "types") return PlayKnowledge::kTypes;
  if (word == "order") return PlayKnowledge::kOrder;
  return std::nullopt;
}

std::vector<std::string> problems(const PlayOptions& options) {
  std::vector<std::string> found = problems(options.planner);
  if (options.n_pick < 1)
    found.push_back("n_pick: " + std::to_string(options.n_pick) + ": must be at least 1");
  if (options.knowledge == PlayKnowledge::kOrder && options.planner.method != PlanMethod::kBest) {
    found.emplace_back("knowledge: the order: only the method best can use it");
  }
  if (!(options.budget_ms >= 0.0)) {
    found.push_back("budget_ms: " + std::to_string(options.budget_ms) + " ms: must not be negative");
  }
  return found;
}

PlayResult playArrivals(const packing::Order& order, const std::vector<int>& arrival,
                        const PlayOptions& options, const PlayProgress& progress) {
  check(order, arrival, options);
  if (options.knowledge == PlayKnowledge::kOrder) return playKnownOrder(order, arrival, options);
  Play play(order, arrival, options);
  while (!play.over()) {
    play.step();
    if (progress) progress(play.done(), static_cast<int>(arrival.size()));
  }
  return play.takeResult();
}

}  // namespace mixed_palletizing::planning
