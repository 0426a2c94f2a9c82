// What the planner may be asked next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <mixed_palletizing/planning/ponderer.hpp>
#include <mixed_palletizing/planning/session_state.hpp>

namespace mixed_palletizing::planning {

/// The situations that may follow when the `visible` items (type indices) stay in sight and `placed` stands on
/// the pallet too: one more of every type that may come, the likeliest first, then none more.
std::vector<ExpectedWorld> expectedWorlds(const OpenPallet& open,
                                          const std::optional<packing::Placement>& placed,
                                          const std::vector<int>& visible, std::uint64_t seed);

/// Those after something else than the decision became of it: `report`, on a pick among `available` of which `chosen`
/// was decided. None when all were discarded.
std::vector<ExpectedWorld> worldsAfter(const PickReported& report, const OpenPallet& open,
                                       const std::vector<int>& available, std::optional<std::size_t> chosen,
                                       std::uint64_t seed);

/// `items` without those at these indices.
std::vector<int> without(const std::vector<int>& items, std::vector<std::size_t> indices);

}  // namespace mixed_palletizing::planning
