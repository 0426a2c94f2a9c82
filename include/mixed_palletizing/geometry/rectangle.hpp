// Rectangles in the plane: footprints of boxes.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace mixed_palletizing::geometry {

/// Rectangle with sides `size.x()` along its yaw direction and `size.y()` across it.
struct Rectangle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  Eigen::Vector2d size = Eigen::Vector2d::Zero();

  Eigen::Vector2d axisX() const;
  Eigen::Vector2d axisY() const;
  double area() const { return size.x() * size.y(); }

  /// Corners counter-clockwise; side i runs from corner i to corner i + 1 and its outward normal is
  /// -y, +x, +y, -x of the rectangle for i = 0..3.
  std::array<Eigen::Vector2d, 4> corners() const;

  /// The point in the rectangle's own axes, origin at its centre.
  Eigen::Vector2d toLocal(const Eigen::Vector2d& point) const;

  /// True when the point lies inside the rectangle grown by `margin` on every side.
  bool contains(const Eigen::Vector2d& point, double margin = 0.0) const;

  /// The same rectangle with size.x() >= size.y() and the yaw in [-pi/2, pi/2).
  Rectangle lengthFirst() const;
};

/// Smallest distance between two rectangles, 0 when they overlap.
double distance(const Rectangle& a, const Rectangle& b);

}  // namespace mixed_palletizing::geometry
