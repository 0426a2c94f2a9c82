// How well a rectangle explains the outline of a top.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/rectangle.hpp>

#include "outline.hpp"

namespace mixed_palletizing::detection {

/// Shares of the outline.
struct OutlineMatch {
  double on_sides_ratio = 0.0;  ///< of the free samples: those that lie on a side
  double occluded_ratio = 0.0;  ///< of all samples
  double border_ratio = 0.0;    ///< of all samples
};

/// A sample lies on a side within the tolerance, at least that many of its pixels.
OutlineMatch matchOutline(const std::vector<OutlineSample>& samples, const geometry::Rectangle& rectangle,
                          double tolerance_m, double tolerance_px);

}  // namespace mixed_palletizing::detection
