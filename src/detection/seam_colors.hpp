// Whether a change of colour along a line is that of two boxes.
#pragma once

#include <array>

#include "seam_lattice.hpp"

namespace mixed_palletizing::detection {

/// What of a lattice is compared: windows on both sides of a place, in some of its lines.
struct SeamWindows {
  int place = 0;
  int near = 0;    ///< places next to it that belong to neither side
  int window = 0;  ///< places of one side
  int first_line = 0;
  int last_line = -1;
};

/// Whether the colour changes by the same amount along most of the lines that show both sides. Where two boxes touch it
/// does; edges of several labels that happen to lie on one line change it by one amount and another. Amounts that
/// differ by less than `tolerance` (of 255) are the same.
bool changesEvenly(const SeamLattice& lattice, const SeamWindows& windows, double tolerance);

/// Whether the surface ends there, seen at two places across: a few millimetres farther along (`sign`: 1, or -1 for
/// backwards) at most half of it is left.
bool surfaceEnds(const SeamLattice& lattice, double along_m, int sign, const std::array<int, 2>& places);

}  // namespace mixed_palletizing::detection
