// A rectangle as its four sides see it, in the order of Rectangle::corners().
#pragma once

#include <array>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/rectangle.hpp>

namespace mixed_palletizing::detection {

// Outward normals in the rectangle's own axes, in the order of Rectangle::corners(), and the directions along.
inline const std::array<Eigen::Vector2d, 4> kOutward{Eigen::Vector2d(0, -1), Eigen::Vector2d(1, 0),
                                                     Eigen::Vector2d(0, 1), Eigen::Vector2d(-1, 0)};
inline Eigen::Vector2d alongOf(std::size_t side) { return {-kOutward[side].y(), kOutward[side].x()}; }

inline double halfAcross(const geometry::Rectangle& r, std::size_t side) {
  return 0.5 * (side % 2 == 0 ? r.size.y() : r.size.x());
}
inline double halfAlong(const geometry::Rectangle& r, std::size_t side) {
  return 0.5 * (side % 2 == 0 ? r.size.x() : r.size.y());
}

/// The rectangle's own axes, kept so that thousands of points do not ask for the same sine.
struct Axes {
  explicit Axes(const geometry::Rectangle& r) : center(r.center), x(r.axisX()), y(r.axisY()) {}
  Eigen::Vector2d local(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d d = point - center;
    return {d.dot(x), d.dot(y)};
  }
  Eigen::Vector2d center;
  Eigen::Vector2d x;
  Eigen::Vector2d y;
};

}  // namespace mixed_palletizing::detection
