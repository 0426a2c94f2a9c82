// The thesis' choice: a genetic search estimates the future of every available item.
#pragma once

#include <cstdint>

#include <mixed_palletizing/planning/next_pick.hpp>

namespace mixed_palletizing::planning {

/// Fills the costs of `decision`'s options, which hold DBLF's placements, and chooses.
void chooseByGeneticSearch(const Situation& situation, const PlannerOptions& options, std::uint64_t seed,
                           const packing::StopCallback& stop, Decision& decision);

}  // namespace mixed_palletizing::planning
