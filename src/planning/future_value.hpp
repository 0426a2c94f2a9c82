// What a future is worth.
#pragma once

#include <mixed_palletizing/planning/playout.hpp>

namespace mixed_palletizing::planning {

/// 1 when nothing is left over, less this many times the volume left over in pallets: what counts most is
/// whether the pallet becomes perfect.
constexpr double kUnpackedWeight = 4.0;

inline double futureValue(const PlayoutEnd& end, double pallet_volume) {
  return (end.perfect() ? 1.0 : 0.0) - kUnpackedWeight * end.unpacked_volume / pallet_volume;
}

}  // namespace mixed_palletizing::planning
