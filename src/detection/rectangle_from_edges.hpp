// Rectangle from the edges of a top: position, orientation and size (thesis 3.2.3, 4.1.7).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <mixed_palletizing/geometry/polygon.hpp>
#include <mixed_palletizing/geometry/rectangle.hpp>

#include "hull_edges.hpp"

namespace mixed_palletizing::detection {

/// `side_found[i]` tells whether side i of the rectangle (in the order of Rectangle::corners()) comes from an
/// edge; the others are put where the hull ends.
struct EdgeRectangle {
  geometry::Rectangle rectangle;
  std::array<bool, 4> side_found{};
};

/// The edge of each side of a top, as far as it has one; side i points i quarter turns further than side 0.
using EdgeSides = std::array<std::optional<Edge>, 4>;

/// The longest edge of each side; side 0 is the longest of all. `edges` run counter-clockwise and are not empty.
EdgeSides pickSides(const std::vector<Edge>& edges);

/// Median [rad] of the sides' directions, each turned back by its quarter turns. Side 0 has an edge.
double medianYaw(const EdgeSides& sides);

/// Rectangle of a counter-clockwise hull and its edges. Edges are paired by their direction against the longest
/// one; of several on one side the longest counts. The yaw is the median of the edges' directions folded by
/// quarter turns; with four sides the centre is where the mean lines of opposite edges cross, and the sizes
/// are measured along the yaw through the centre (eq. 4.1, 4.2), which does not need parallel edges as
/// eq. 3.11 does. Without any edge it is the hull's rectangle of the smallest area. Throws
/// std::invalid_argument for a hull of fewer than 3 corners.
EdgeRectangle rectangleFromEdges(const geometry::Polygon& hull, const std::vector<Edge>& edges);

}  // namespace mixed_palletizing::detection
