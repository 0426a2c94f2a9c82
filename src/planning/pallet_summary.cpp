// The part of PalletSession that sums up a pallet.
#include <algorithm>
#include <numeric>

#include <mixed_palletizing/planning/pallet_session.hpp>

#include "pallet_stability.hpp"

namespace mixed_palletizing::planning {

PalletSummary PalletSession::summary() const {
  PalletSummary summary;
  const OpenPallet* open = state_.open();
  if (open == nullptr) return summary;
  summary.pallet_id = open->id;
  summary.placed = static_cast<int>(open->pallet.placements().size());
  summary.discarded = std::accumulate(open->discarded.begin(), open->discarded.end(), 0);
  summary.remaining = std::accumulate(open->remaining.begin(), open->remaining.end(), 0);
  summary.utilization = open->pallet.utilization();
  summary.center_of_gravity_mm = centreOfGravity(open->pallet, open->order);
  summary.min_support_ratio = leastSupport(open->pallet);
  summary.gravity_margin_mm = gravityMargin(open->pallet, summary.center_of_gravity_mm);
  for (std::size_t t = 0; t < open->order.types.size(); ++t) {
    summary.unpacked_volume_ratio += static_cast<double>(open->discarded[t] + open->remaining[t]) *
                                     static_cast<double>(packing::volume(open->order.types[t].size));
  }
  summary.unpacked_volume_ratio /= static_cast<double>(packing::volume(open->order.rules.size));
  std::vector<double> times = open->decision_ms;
  std::sort(times.begin(), times.end());
  summary.decisions = static_cast<int>(times.size());
  if (times.empty()) return summary;
  summary.median_decision_ms = times[(times.size() - 1) / 2];
  summary.p99_decision_ms = times[(times.size() * 99 + 99) / 100 - 1];
  summary.max_decision_ms = times.back();
  return summary;
}

}  // namespace mixed_palletizing::planning
