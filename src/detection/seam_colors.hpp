// Whether a change of colour along a line is that of two boxes.
#pragma once

#include <array>
#include <vector>

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

/// Keeps its memory between calls.
class SeamColors {
 public:
  /// Whether the colour changes from one box's to another's: by the same amount along most of the lines that show both
  /// sides, and no line shows on one side what is usual on the other. Edges of several labels that happen to lie on one
  /// line change it by one amount and another, or on one side here and on the other there, where the same carton shows
  /// on both. Colours that differ by less than `tolerance` (of 255) are the same.
  bool differ(const SeamLattice& lattice, const SeamWindows& windows, double tolerance);

  /// Whether most of the lines that show both sides change by more than `tolerance`; also when there are hardly any.
  bool goesOn(const SeamLattice& lattice, const SeamWindows& windows, double tolerance);

  /// How much the colour changes along half of the lines, of 255.
  double changeAt(const SeamLattice& lattice, const SeamWindows& windows);

 private:
  using Color = std::array<double, 3>;
  void read(const SeamLattice& lattice, const SeamWindows& windows);
  Color usualOf(const std::vector<Color>& colors);

  std::vector<Color> lows_, highs_, changes_;  // of each line
  std::vector<double> values_;
};

}  // namespace mixed_palletizing::detection
