// The choice over pairs of an available item and a placement, by playing their futures.
#pragma once

#include <cstdint>

#include <mixed_palletizing/planning/next_pick.hpp>

namespace mixed_palletizing::planning {

/// Chooses, and replaces the placements of `decision`'s options, which hold DBLF's, by the best found. When
/// `stop` leaves no time for a future, the pair that the policy rates best is chosen.
void chooseByPlayouts(const Situation& situation, const PlannerOptions& options, std::uint64_t seed,
                      const packing::StopCallback& stop, Decision& decision);

}  // namespace mixed_palletizing::planning
