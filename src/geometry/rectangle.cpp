#include <algorithm>
#include <cmath>

#include <mixed_palletizing/geometry/pose.hpp>
#include <mixed_palletizing/geometry/rectangle.hpp>

namespace mixed_palletizing::geometry {
namespace {

/// Distance of a point from the filled rectangle.
double distanceTo(const Rectangle& rectangle, const Eigen::Vector2d& point) {
  const Eigen::Vector2d outside =
      (rectangle.toLocal(point).cwiseAbs() - 0.5 * rectangle.size).cwiseMax(Eigen::Vector2d::Zero());
  return outside.norm();
}

/// True when one side direction of `a` separates the two rectangles.
bool separatedByAxesOf(const Rectangle& a, const Rectangle& b) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(INFINITY);
  Eigen::Vector2d high = -low;
  for (const Eigen::Vector2d& corner : b.corners()) {
    const Eigen::Vector2d local = a.toLocal(corner);
    low = low.cwiseMin(local);
    high = high.cwiseMax(local);
  }
  const Eigen::Vector2d half = 0.5 * a.size;
  return (low.array() > half.array()).any() || (high.array() < -half.array()).any();
}

}  // namespace

Eigen::Vector2d Rectangle::axisX() const { return {std::cos(yaw_rad), std::sin(yaw_rad)}; }

Eigen::Vector2d Rectangle::axisY() const { return {-std::sin(yaw_rad), std::cos(yaw_rad)}; }

std::array<Eigen::Vector2d, 4> Rectangle::corners() const {
  const Eigen::Vector2d x = 0.5 * size.x() * axisX();
  const Eigen::Vector2d y = 0.5 * size.y() * axisY();
  return {center - x - y, center + x - y, center + x + y, center - x + y};
}

Eigen::Vector2d Rectangle::toLocal(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d d = point - center;
  return {d.dot(axisX()), d.dot(axisY())};
}

bool Rectangle::contains(const Eigen::Vector2d& point, double margin) const {
  return (toLocal(point).cwiseAbs().array() <= (0.5 * size).array() + margin).all();
}

Rectangle Rectangle::lengthFirst() const {
  Rectangle turned = *this;
  if (size.x() < size.y()) {
    turned.size = Eigen::Vector2d(size.y(), size.x());
    turned.yaw_rad += M_PI / 2;
  }
  turned.yaw_rad = foldHalfTurn(turned.yaw_rad);
  return turned;
}

double distance(const Rectangle& a, const Rectangle& b) {
  if (!separatedByAxesOf(a, b) && !separatedByAxesOf(b, a)) return 0.0;
  // Two separate convex polygons are nearest at a corner of one of them.
  double nearest = INFINITY;
  for (const Eigen::Vector2d& corner : a.corners()) nearest = std::min(nearest, distanceTo(b, corner));
  for (const Eigen::Vector2d& corner : b.corners()) nearest = std::min(nearest, distanceTo(a, corner));
  return nearest;
}

}  // namespace mixed_palletizing::geometry
