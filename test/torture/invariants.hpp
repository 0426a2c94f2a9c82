// What must hold of every placement, every decision and every thread, over random cases by a seed.
#pragma once

#include <cstdint>

#include "tally.hpp"

namespace mixed_palletizing::torture {

/// Random placements and undos on small pallets with any rules: no overlap, inside, supported, and the spaces those of
/// their definition, cell by cell. A case is a placement.
Cases placeAtRandom(long placements, std::uint64_t seed);

/// One thread and two must answer the same: packer, planner, simulator, and detectors side by side. A case is a seed.
Cases compareThreads(long seeds, std::uint64_t seed);

/// Pallets built by the planner while boxes are put down up to 50 mm and 10 degrees off, are missing, swapped for others,
/// added, or fall off again. A case is a deviation: what is within the tolerances is the plan, what is beyond is known to
/// the planner where it may stay and refused where not, and no place it then names is unsupported.
Cases deviate(long deviations, std::uint64_t seed);

}  // namespace mixed_palletizing::torture
