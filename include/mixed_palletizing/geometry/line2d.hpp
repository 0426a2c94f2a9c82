// Lines in the plane in homogeneous form (thesis 2.2.2).
#pragma once

#include <optional>

#include <Eigen/Core>

namespace mixed_palletizing::geometry {

/// Points p with normal . p + offset = 0 (thesis eq. 2.6); the normal has length 1, the offset the points'
/// unit.
struct Line2d {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double offset = 0.0;

  /// Line through two points (eq. 2.8); the normal lies to the left of a -> b.
  /// Throws std::invalid_argument when they coincide.
  static Line2d through(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

  /// Unit vector along the line; the normal lies to its left.
  Eigen::Vector2d direction() const { return {normal.y(), -normal.x()}; }

  /// Distance of a point, positive on the side the normal points to.
  double signedDistance(const Eigen::Vector2d& point) const { return normal.dot(point) + offset; }
};

/// Common point of two lines (eq. 2.7); nothing for parallel lines (angle below 1e-9 rad).
std::optional<Eigen::Vector2d> intersection(const Line2d& a, const Line2d& b);

/// Line half way between two lines that are about parallel, in either sense of their normals: the bisector of
/// the smaller angle between them. It keeps the sense of `a`.
Line2d meanLine(const Line2d& a, const Line2d& b);

}  // namespace mixed_palletizing::geometry
