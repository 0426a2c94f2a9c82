// Sizes of a top from its edges by the formulas of thesis 3.2.3 and 4.1.7.
#pragma once

#include <mixed_palletizing/detection/top_study.hpp>

#include "rectangle_from_edges.hpp"

namespace mixed_palletizing::detection {

/// Nothing unless all four sides have an edge and their mean lines cross.
std::optional<EdgeSizes> sizesFromEdges(const EdgeSides& sides);

/// Largest angle [rad] between opposite edges; 0 when no side has its opposite.
double largestEdgeAngle(const EdgeSides& sides);

}  // namespace mixed_palletizing::detection
