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

#include "edge_walks.hpp"
#include "rectangle_from_edges.hpp"
#include "side_votes.hpp"

namespace mixed_palletizing::detection {

struct SideFit {
  bool found = false;  ///< false: the side is where the starting rectangle had it
  std::size_t samples = 0;
  double stddev_m = 0.0;  ///< of the side's offset; 0 when nothing is known of it
};

struct RectangleFit {
  geometry::Rectangle rectangle;
  geometry::Rectangle ends;      ///< the sides where the surface ends, before its rounded edges
  std::array<SideFit, 4> sides;  ///< in the order of Rectangle::corners()
  double yaw_stddev_rad = 0.0;
  double rounding_m = 0.0;  ///< radius of the edges; 0 when they are sharp or nothing tells
  int foundSides() const;
};

/// Lengths that scale the fit [m].
struct FitScale {
  double spacing_m = 0.0;  ///< between neighbouring points on the top
  double noise_m = 0.0;    ///< standard deviation of the points
  double ripple_m = 0.0;   ///< part of it that neighbouring points share
  double uneven_m = 0.0;   ///< standard deviation of the surface's own shape
  double bend_m = 0.0;     ///< drop at which a surface that bends down has ended
  Eigen::Vector3d camera =
      Eigen::Vector3d(0.0, 0.0, 1e6);  ///< place, z above the top; default: straight above
};

/// Memory of a fit, kept between calls.
struct FitBuffers {
  std::array<SideVotes, 4> sides;
  std::vector<double> values, others;
};

/// Moves the starting rectangle onto the samples: one angle and four offsets with Tukey's weights. Where a face
/// below stands out beyond the side (a rounded edge), the side is moved onto the face. Sides with too few samples
/// keep their place.
RectangleFit fitRectangle(const std::vector<EdgeSample>& samples, const EdgeRectangle& start,
                          const FitScale& scale, FitBuffers& buffers);

/// The starting rectangle as it is, with the spread of its edges: the thesis' result.
RectangleFit keepRectangle(const EdgeRectangle& start, const FitScale& scale);

}  // namespace mixed_palletizing::detection
