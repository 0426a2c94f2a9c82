// Height of a box in a stack, from the side faces that the camera sees.
#pragma once

#include <optional>

#include <mixed_palletizing/geometry/rectangle.hpp>

#include "top_segments.hpp"

namespace mixed_palletizing::detection {

struct SideHeight {
  double height_m = 0.0;
  double stddev_m = 0.0;
};

/// Drop from a top at `top_m` down to the level surface at the foot of those of its sides that face the camera: there
/// face and foot are both in view. The smallest drop that most of a side shows is the box's own; nothing when no side
/// shows one. Boxes that stand flush on each other
/// look like one: their joint is no step; and beside a lower neighbour only what rises above it is seen. So the
/// standard deviation holds half of what the sides differ by, and half of the height of a foot above the lowest
/// points of the stack when no second side agrees on it.
std::optional<SideHeight> heightOfSides(const HeightRaster& raster, const TopSegments& segments,
                                        const geometry::Rectangle& rectangle, double top_m,
                                        const Eigen::Vector3d& camera, double step_m);

}  // namespace mixed_palletizing::detection
