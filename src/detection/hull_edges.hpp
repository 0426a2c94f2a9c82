// Convex hull of a top and its edges by Algorithm 2 of the thesis (3.2.2 "Edges estimation").
//
// Reading of Algorithm 2. The pseudo code adds an edge when the direction changes by more than th_add and merges
// when it changes by less than th_merge; with the values printed in 4.1.3 (th_add = 10, th_merge = 80 degrees)
// a change between them would do both. The thresholds are used the other way round here, which fits the text
// and figure 3.11: less than 10 degrees is the same edge going on, more than 80 degrees a new edge, and a
// vector in between cuts a corner and is neither. The direction of comparison is that of the whole edge so
// far, not of its last vector, so that a rounded outline cannot turn by many small steps; it stays when a
// vector is skipped; and the hull is closed, so the last edge may go on in the first.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/polygon.hpp>

namespace mixed_palletizing::detection {

struct Edge {
  Eigen::Vector2d from;
  Eigen::Vector2d to;

  Eigen::Vector2d along() const { return to - from; }
  double length() const { return along().norm(); }
};

/// Convex hull (Quickhull, Algorithm 1, by PCL), counter-clockwise; empty when the points are fewer than 3 or
/// on one line.
geometry::Polygon convexHull(const std::vector<Eigen::Vector2d>& points);

/// Edges around a counter-clockwise hull, in its order. `min_length_m` is th_length, grown by the caller for
/// coarse sensors.
std::vector<Edge> findEdges(const geometry::Polygon& hull, double min_length_m, const TopOptions& options);

}  // namespace mixed_palletizing::detection
