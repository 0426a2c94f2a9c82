// Where a change of colour along a line ends: as boxes do, or as prints do.
#pragma once

#include <array>
#include <vector>

#include "rectangle_cover.hpp"
#include "seam_lattice.hpp"

namespace mixed_palletizing::detection {

/// One end of a change of colour across `axis`.
struct SeamEnd {
  int axis = 0;
  double at_m = 0.0;  ///< along
  int sign = 1;       ///< which end: 1, or -1 for the end backwards
};

/// Whether a change of colour ends there as boxes do: at the end of the surface, seen at two places across, or at one of
/// the seams. Prints end in between.
bool endsAsBoxes(const SeamLattice& lattice, const std::vector<Seam>& seams, const SeamEnd& end,
                 const std::array<int, 2>& places);

/// First and last line behind that end, up to the next seam across; the first is above the last when there is none.
std::array<int, 2> linesBehind(const SeamLattice& lattice, const std::vector<Seam>& seams,
                               const SeamEnd& end);

}  // namespace mixed_palletizing::detection
