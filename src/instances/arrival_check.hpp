// The rules of arrival: which items can be picked at each moment.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/instances/instance.hpp>
#include <mixed_palletizing/instances/packing_result.hpp>

namespace mixed_palletizing::instances {

/// Plays the arrival along the placements: the stated `available` items, the choice among them, and that
/// items were only discarded when none of them fitted (decided with full support and without limits on tops
/// only, where it can be decided exactly). Item indices and placements must be sound. One line a fault, the first ends the play.
std::vector<std::string> arrivalFaults(const Instance& instance, const PackingResult& result);

}  // namespace mixed_palletizing::instances
