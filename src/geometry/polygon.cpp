#include <cmath>
#include <stdexcept>
#include <string>

#include <mixed_palletizing/geometry/polygon.hpp>

namespace mixed_palletizing::geometry {
namespace {

Rectangle boundsAlong(const Polygon& polygon, double yaw_rad) {
  Rectangle bounds;
  bounds.yaw_rad = yaw_rad;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(INFINITY);
  Eigen::Vector2d high = -low;
  for (const Eigen::Vector2d& corner : polygon) {
    const Eigen::Vector2d local(corner.dot(bounds.axisX()), corner.dot(bounds.axisY()));
    low = low.cwiseMin(local);
    high = high.cwiseMax(local);
  }
  const Eigen::Vector2d middle = 0.5 * (low + high);
  bounds.center = middle.x() * bounds.axisX() + middle.y() * bounds.axisY();
  bounds.size = high - low;
  return bounds;
}

}  // namespace

double signedArea(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d a = polygon[i] - polygon[0];
    const Eigen::Vector2d b = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

Rectangle minimumAreaRectangle(const Polygon& convex_polygon) {
  if (convex_polygon.size() < 3) {
    throw std::invalid_argument("minimumAreaRectangle: " + std::to_string(convex_polygon.size()) +
                                " corners, at least 3 needed");
  }
  Rectangle best;
  double best_area = INFINITY;
  for (std::size_t i = 0; i < convex_polygon.size(); ++i) {
    const Eigen::Vector2d side = convex_polygon[(i + 1) % convex_polygon.size()] - convex_polygon[i];
    const Rectangle bounds = boundsAlong(convex_polygon, std::atan2(side.y(), side.x()));
    if (bounds.area() < best_area) {
      best_area = bounds.area();
      best = bounds;
    }
  }
  return best.lengthFirst();
}

}  // namespace mixed_palletizing::geometry
