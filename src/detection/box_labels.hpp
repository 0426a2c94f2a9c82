// Pixels of the found boxes: their tops and what is seen of their sides.
#pragma once

#include <cstdint>
#include <vector>

#include "box_candidate.hpp"
#include "cell_grid.hpp"

namespace mixed_palletizing::detection {

/// Writes value i + 1 for the points of boxes[i] into the grid of labels and counts them.
void labelBoxes(const BaseCloud& cloud, const CellGrid& cells, const ClusterLimits& limits,
                std::vector<FoundBox>& boxes, std::vector<std::uint16_t>& labels);

}  // namespace mixed_palletizing::detection
