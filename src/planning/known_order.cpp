// A beam search over plays of the policy: the states after each decision are worth what the policy makes of them with
// the arrivals as they will come; the best are followed, then all of it again with a beam of twice the width.
#include "known_order.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>
#include <utility>

#include <mixed_palletizing/planning/playout.hpp>

#include "scored_placements.hpp"

namespace mixed_palletizing::planning {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kFirstWidth = 4;
constexpr std::size_t kBranches = 10;  ///< tried from a state: those that the policy rates best
constexpr std::size_t kShareOfEquals =
    4;  ///< at most this part of a beam may be worth the same: they differ little

/// Who was placed and who discarded: what is not visible when it is placed came after a discard, because a type that
/// fits is never discarded.
PlayResult retold(const packing::PalletState& pallet, const std::vector<int>& arrival, int n_pick) {
  PlayResult result;
  std::vector<int> visible;
  std::size_t next = 0;
  const auto arrive = [&] {
    while (visible.size() < static_cast<std::size_t>(n_pick) && next < arrival.size()) {
      visible.push_back(static_cast<int>(next++));
    }
  };
  const auto discard = [&] {
    result.unpacked.insert(result.unpacked.end(), visible.begin(), visible.end());
    visible.clear();
    arrive();
  };
  arrive();
  for (const packing::Placement& placement : pallet.placements()) {
    const auto isOfType = [&](int item) { return arrival[static_cast<std::size_t>(item)] == placement.type; };
    auto item = std::find_if(visible.begin(), visible.end(), isOfType);
    while (item == visible.end()) {
      discard();
      item = std::find_if(visible.begin(), visible.end(), isOfType);
    }
    result.placements.push_back({*item, placement, visible});
    visible.erase(item);
    arrive();
  }
  while (!visible.empty()) discard();
  result.utilization = pallet.utilization();
  return result;
}

class KnownOrderSearch {
 public:
  KnownOrderSearch(const packing::Order& order, const std::vector<int>& arrival, const PlayOptions& options)
      : arrival_(arrival),
        playout_(order.types, order.rules, options.planner.best.weights, options.planner.gripper),
        gripper_(options.planner.gripper),
        budget_(options.budget_ms * static_cast<double>(arrival.size())),
        start_{
            {packing::PalletState(order), std::vector<int>(order.types.size(), 0), options.n_pick}, 0, 0.0},
        pallet_(order) {
    arrive(start_);
    judge(start_);
  }

  packing::PalletState run() {
    for (std::size_t width = kFirstWidth; !over(); width *= 2) {
      if (!follow(width)) break;
    }
    return pallet_;
  }

 private:
  struct State {
    PlayoutStart at;
    std::size_t next = 0;  ///< in the arrival
    double value = 0.0;
  };

  bool over() const {
    if (pallet_.placements().size() == arrival_.size()) return true;
    return budget_.count() > 0.0 ? Clock::now() - began_ >= budget_ : plays_ >= kKnownOrderPlays;
  }

  /// False when no state had to be left out, so that a wider beam would find the same.
  bool follow(std::size_t width) {
    bool left_out = false;
    std::vector<State> beam{start_};
    while (!beam.empty() && !over()) {
      std::vector<State> reached;
      for (State& state : beam) left_out = branch(state, reached) || left_out;
      std::stable_sort(reached.begin(), reached.end(),
                       [](const State& a, const State& b) { return a.value > b.value; });
      std::map<double, std::size_t> equals;
      beam.clear();
      for (State& state : reached) {
        if (beam.size() < width && equals[state.value]++ < width / kShareOfEquals) {
          beam.push_back(std::move(state));
        } else {
          left_out = true;
        }
      }
    }
    return left_out;
  }

  /// True when there were more ways on than were tried.
  bool branch(State& state, std::vector<State>& reached) {
    const auto none = [](int count) { return count == 0; };
    while (!std::all_of(state.at.visible.begin(), state.at.visible.end(), none)) {
      const std::vector<ScoredPlacement> pairs = pairsOf(state);
      for (std::size_t i = 0; i < std::min(kBranches, pairs.size()) && !over(); ++i) {
        State after = state;
        after.at.pallet.place(pairs[i].placement);
        --after.at.visible[static_cast<std::size_t>(pairs[i].placement.type)];
        arrive(after);
        judge(after);
        reached.push_back(std::move(after));
      }
      if (!pairs.empty()) return pairs.size() > kBranches;
      std::fill(state.at.visible.begin(), state.at.visible.end(), 0);  // discarded
      arrive(state);
    }
    return false;
  }

  std::vector<ScoredPlacement> pairsOf(const State& state) {
    std::vector<int> types;
    for (std::size_t t = 0; t < state.at.visible.size(); ++t) {
      if (state.at.visible[t] > 0) types.push_back(static_cast<int>(t));
    }
    std::vector<int> remaining = state.at.visible;
    for (std::size_t i = state.next; i < arrival_.size(); ++i) {
      ++remaining[static_cast<std::size_t>(arrival_[i])];
    }
    return scoredPlacements(state.at.pallet, types, std::move(remaining), gripper_, playout_.policy(), {});
  }

  void arrive(State& state) const {
    int visible = std::accumulate(state.at.visible.begin(), state.at.visible.end(), 0);
    for (; visible < state.at.n_pick && state.next < arrival_.size(); ++visible) {
      ++state.at.visible[static_cast<std::size_t>(arrival_[state.next++])];
    }
  }

  void judge(State& state) {
    const auto rest = arrival_.begin() + static_cast<std::ptrdiff_t>(state.next);
    state.value = playout_.play(state.at, {rest, arrival_.end()}, {})->utilization;
    if (plays_++ > 0 && state.value <= best_value_) return;
    best_value_ = state.value;
    pallet_ = playout_.pallet();
  }

  const std::vector<int>& arrival_;
  Playout playout_;
  const GripperEnvelope& gripper_;
  std::chrono::duration<double, std::milli> budget_;  ///< 0 = so many plays
  Clock::time_point began_ = Clock::now();
  State start_;
  packing::PalletState pallet_;  ///< the fullest one found
  double best_value_ = 0.0;      ///< its utilization
  int plays_ = 0;
};

}  // namespace

PlayResult playKnownOrder(const packing::Order& order, const std::vector<int>& arrival,
                          const PlayOptions& options) {
  const Clock::time_point start = Clock::now();
  PlayResult result = retold(KnownOrderSearch(order, arrival, options).run(), arrival, options.n_pick);
  const auto spent = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  const std::size_t decisions = std::max<std::size_t>(result.placements.size(), 1);
  result.decision_ms.assign(decisions, spent / static_cast<double>(decisions));
  return result;
}

}  // namespace mixed_palletizing::planning
