// The boxes of one level surface: cut along the seams between them.
#pragma once

#include <array>
#include <vector>

#include "top_picture.hpp"

namespace mixed_palletizing::detection {

/// A side of a part: across = offset + slope * along, in cells of the picture. Sides are numbered as those of
/// geometry::Rectangle: low v, high u, high v, low u; across is v for the first and third, u for the others.
struct PartSide {
  double offset = 0.0;
  double slope = 0.0;
  bool seam = false;  ///< another box of the same height lies behind it
};

using TopPart = std::array<PartSide, 4>;

struct SplitLimits {
  double min_side_m = 0.04;
  double min_evidence = 0.55;  ///< share of a cut's length that shows a seam
};

/// Cuts the surface from side to side, the clearest seam first, until no part shows one. A seam is a dark line between
/// two about equally bright areas, a gap, a step down, or the border of something much darker or brighter. Print and
/// tape are smaller steps of brightness and are none.
std::vector<TopPart> splitTop(const TopPicture& picture, const SplitLimits& limits);

/// 0 to 1: how much the picture looks like a seam at a place, for a seam along v (`upright`) or along u.
double seamEvidence(const TopPicture& picture, double u, double v, bool upright);

}  // namespace mixed_palletizing::detection
