// Pixels of the found boxes: their tops and what is seen of their sides.
#pragma once

#include <cstdint>
#include <vector>

#include "box_candidate.hpp"
#include "cell_grid.hpp"

namespace mixed_palletizing::detection {

/// Writes value i + 1 for the points of boxes[i] into the grid of labels and counts them. `taken` becomes 1 for every
/// cell most of whose points are labelled, 0 for the others.
void labelBoxes(const BaseCloud& cloud, const CellGrid& cells, const ClusterLimits& limits,
                std::vector<FoundBox>& boxes, std::vector<std::uint16_t>& labels, std::vector<char>& taken);

}  // namespace mixed_palletizing::detection
