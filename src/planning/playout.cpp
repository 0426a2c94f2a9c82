#include <limits>
#include <numeric>

#include <mixed_palletizing/planning/playout.hpp>

#include "scored_placements.hpp"

namespace mixed_palletizing::planning {

Playout::Playout(const std::vector<packing::ItemType>& types, const packing::PalletRules& rules,
                 const PolicyWeights& weights, const GripperEnvelope& gripper)
    : policy_(types, rules, weights), gripper_(gripper), pallet_(rules) {}

std::optional<PlayoutEnd> Playout::play(const PlayoutStart& start, const std::vector<int>& to_come,
                                        const packing::StopCallback& stop) {
  pallet_ = start.pallet;
  visible_ = start.visible;
  remaining_ = visible_;
  for (const int type : to_come) ++remaining_[static_cast<std::size_t>(type)];
  visible_count_ = std::accumulate(visible_.begin(), visible_.end(), 0);
  std::size_t next = 0;
  PlayoutEnd end;
  stopped_ = false;
  arrive(start.n_pick, to_come, next);
  while (true) {
    if (stop && stop()) return std::nullopt;  // here too: there may be no placement to try
    if (visible_count_ == 0) break;
    const bool placed = placeBest(stop);
    if (stopped_) return std::nullopt;
    if (!placed) discardVisible(end);
    arrive(start.n_pick, to_come, next);
  }
  end.utilization = pallet_.utilization();
  return end;
}

/// False when nothing visible fits, or when stopped.
bool Playout::placeBest(const packing::StopCallback& stop) {
  double best_score = -std::numeric_limits<double>::infinity();
  std::optional<packing::Placement> best;
  for (int type = 0; type < static_cast<int>(visible_.size()); ++type) {
    const auto t = static_cast<std::size_t>(type);
    if (visible_[t] == 0) continue;
    placementsOf(pallet_, policy_.sizes(type), type, Trials::kQuick, gripper_, placements_);
    if (placements_.empty()) continue;
    --remaining_[t];
    policy_.prepare(pallet_, remaining_);
    ++remaining_[t];
    for (const packing::Placement& placement : placements_) {
      if (stop && stop()) {
        stopped_ = true;
        return false;
      }
      const double score = policy_.score(placement);
      if (score <= best_score) continue;
      best_score = score;
      best = placement;
    }
  }
  if (!best) return false;
  pallet_.place(*best);
  --visible_[static_cast<std::size_t>(best->type)];
  --remaining_[static_cast<std::size_t>(best->type)];
  --visible_count_;
  return true;
}

void Playout::discardVisible(PlayoutEnd& end) {
  for (std::size_t t = 0; t < visible_.size(); ++t) {
    end.unpacked_volume += visible_[t] * policy_.itemVolume(static_cast<int>(t));
    remaining_[t] -= visible_[t];
    visible_[t] = 0;
  }
  end.unpacked += visible_count_;
  visible_count_ = 0;
}

void Playout::arrive(int n_pick, const std::vector<int>& to_come, std::size_t& next) {
  for (; visible_count_ < n_pick && next < to_come.size(); ++next, ++visible_count_) {
    ++visible_[static_cast<std::size_t>(to_come[next])];
  }
}

}  // namespace mixed_palletizing::planning
