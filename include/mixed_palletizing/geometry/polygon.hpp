// Polygons in the plane.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/rectangle.hpp>

namespace mixed_palletizing::geometry {

using Polygon = std::vector<Eigen::Vector2d>;

/// Area by the shoelace formula: positive for counter-clockwise corners, 0 for fewer than 3.
double signedArea(const Polygon& polygon);

/// Rectangle of the smallest area around a convex polygon: one of its sides lies on a side of the polygon.
/// Throws std::invalid_argument for fewer than 3 corners.
Rectangle minimumAreaRectangle(const Polygon& convex_polygon);

}  // namespace mixed_palletizing::geometry
