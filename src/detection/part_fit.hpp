// The rectangle of one part of a level surface.
#pragma once

#include <array>

#include <mixed_palletizing/geometry/rectangle.hpp>

#include "top_split.hpp"

namespace mixed_palletizing::detection {

/// What lies behind a side of a part.
struct SideView {
  double below =
      0.0;  ///< share of its length where something lower, or another box's top behind a seam, is seen
  double above = 0.0;  ///< something higher: it may hide a piece of the top
  double stddev_m = 0.0;
};

struct PartFit {
  geometry::Rectangle rectangle;  ///< base frame; its x along the picture's u
  std::array<SideView, 4> sides;  ///< numbered as those of the rectangle
  double filled = 0.0;            ///< share of the rectangle that is top
  double yaw_stddev_rad = 0.0;
};

/// One angle and four offsets fitted robustly to the places where the part ends: the middle of a seam, else the step of
/// brightness nearest to where the surface ends, else that end itself (depth is often smeared there).
PartFit fitPart(const TopPicture& picture, const TopPart& part);

}  // namespace mixed_palletizing::detection
