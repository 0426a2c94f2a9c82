// Robust rectangle through the outline of a top: one common angle and four offsets.
//
// Goes beyond the thesis, which takes hull vertices for edges: a hull lies outside of the noise, and its edges
// neither are parallel nor use the points between the vertices. Here every free outline sample votes, with
// Tukey's weights, and the sides are orthogonal by construction.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/rectangle.hpp>

#include "outline.hpp"
#include "rectangle_from_edges.hpp"

namespace mixed_palletizing::detection {

struct SideFit {
  bool found = false;  ///< false: the side is where the starting rectangle had it
  std::size_t samples = 0;
  double stddev_m = 0.0;  ///< of the side's offset, only when found
};

struct RectangleFit {
  geometry::Rectangle rectangle;
  std::array<SideFit, 4> sides;  ///< in the order of Rectangle::corners()
  double yaw_stddev_rad = 0.0;
  int foundSides() const;
};

/// Lengths that scale the fit [m].
struct FitScale {
  double spacing_m = 0.0;  ///< between neighbouring points on the top
  double noise_m = 0.0;    ///< standard deviation of the points
  double ripple_m = 0.0;   ///< part of it that neighbouring points share
};

/// Moves the starting rectangle onto the samples. A side that the camera looks at from outside ends where its
/// face begins (OutlineSample::at_band), another where the top ends (at_top). Sides with too few samples keep
/// their place.
RectangleFit fitRectangle(const std::vector<OutlineSample>& samples, const EdgeRectangle& start,
                          const Eigen::Vector2d& camera, const FitScale& scale);

/// The starting rectangle as it is, with the spread of its edges: the thesis' result.
RectangleFit keepRectangle(const EdgeRectangle& start, const FitScale& scale);

}  // namespace mixed_palletizing::detection
