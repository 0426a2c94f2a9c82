// Standard deviations and covariance of a box from its fit and the noise.
#pragma once

#include <Eigen/Core>

#include <mixed_palletizing/detection/detections.hpp>

#include "rectangle_fit.hpp"
#include "top_surface.hpp"

namespace mixed_palletizing::detection {

/// Fills size_stddev and pose_covariance of `box` (yaw, size and top_visibility already set, from `fit`). A side that
/// was not found may lie anywhere up to the largest box: its size gets the standard deviation of that range.
void estimateUncertainty(const RectangleFit& fit, const TopSurface& top, double ripple_m, double max_side_m,
                         DetectedBox& box);

}  // namespace mixed_palletizing::detection
