// How even a top is.
#pragma once

#include <mixed_palletizing/geometry/rectangle.hpp>

#include "base_cloud.hpp"
#include "grid_runs.hpp"

namespace mixed_palletizing::detection {

/// Largest distance [m] of the mean height of one cell from the top's mean height, over the well filled cells of
/// a grid on the rectangle: bulges, dents and tilt count, noise averages out.
double unevenness(const BaseCloud& cloud, const RunRange& top, const geometry::Rectangle& rectangle);

}  // namespace mixed_palletizing::detection
