#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/geometry/line2d.hpp>

namespace mixed_palletizing::geometry {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

Line2d Line2d::through(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length = along.norm();
  if (!(length > 0.0)) throw std::invalid_argument("Line2d::through: the two points coincide");
  Line2d line;
  line.normal = Eigen::Vector2d(-along.y(), along.x()) / length;
  line.offset = -line.normal.dot(0.5 * (a + b));
  return line;
}

std::optional<Eigen::Vector2d> intersection(const Line2d& a, const Line2d& b) {
  const double w = cross(a.normal, b.normal);
  if (std::abs(w) < 1e-9) return std::nullopt;
  return Eigen::Vector2d((a.normal.y() * b.offset - b.normal.y() * a.offset) / w,
                         (b.normal.x() * a.offset - a.normal.x() * b.offset) / w);
}

Line2d meanLine(const Line2d& a, const Line2d& b) {
  const double sense = a.normal.dot(b.normal) < 0.0 ? -1.0 : 1.0;
  Line2d mean;
  mean.normal = a.normal + sense * b.normal;
  const double length = mean.normal.norm();
  mean.normal /= length;
  mean.offset = (a.offset + sense * b.offset) / length;
  return mean;
}

}  // namespace mixed_palletizing::geometry
