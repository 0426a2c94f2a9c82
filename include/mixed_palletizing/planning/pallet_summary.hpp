// What became of a pallet.
#pragma once

#include <array>
#include <string>

namespace mixed_palletizing::planning {

struct PalletSummary {
  std::string pallet_id;
  int placed = 0;
  int discarded = 0;
  int remaining = 0;  ///< neither placed nor discarded when the pallet was closed
  double utilization = 0.0;
  std::array<double, 3> center_of_gravity_mm{};  ///< by volume where weights are not known
  int decisions = 0;
  double median_decision_ms = 0.0;
  double p99_decision_ms = 0.0;
  double max_decision_ms = 0.0;
  double unpacked_volume_ratio = 0.0;  ///< of the items discarded or never come, in volumes of the pallet
  double min_support_ratio = 1.0;      ///< the least supported base of all boxes; 1 when none was placed
  double gravity_margin_mm =
      0.0;  ///< centre of gravity to the nearest edge of the floor area the boxes cover
};

}  // namespace mixed_palletizing::planning
