#include "visibility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mixed_palletizing::simulation {
namespace {

/// What is nearer to the camera's plane than this [m] is cut off: its projection has no end.
constexpr double kNear = 0.02;

std::vector<Eigen::Vector2d> project(const std::vector<Eigen::Vector3d>& face, const Pinhole& pinhole) {
  std::vector<Eigen::Vector2d> corners;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Eigen::Vector3d& a = face[i];
    const Eigen::Vector3d& b = face[(i + 1) % face.size()];
    if (a.z() >= kNear) corners.push_back(pinhole.project(a));
    if ((a.z() >= kNear) != (b.z() >= kNear)) {
      corners.push_back(pinhole.project(a + (b - a) * ((kNear - a.z()) / (b.z() - a.z()))));
    }
  }
  return corners;
}

/// Integers within [low, high].
std::uint64_t integersWithin(double low, double high) {
  const double count = std::floor(high) - std::ceil(low) + 1.0;
  return count > 0.0 ? static_cast<std::uint64_t>(count) : 0;
}

}  // namespace

std::uint64_t projectedPixels(const std::vector<Eigen::Vector3d>& convex_face, const Pinhole& pinhole) {
  const std::vector<Eigen::Vector2d> corners = project(convex_face, pinhole);
  if (corners.size() < 3) return 0;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double top = kInfinity;
  double bottom = -kInfinity;
  for (const Eigen::Vector2d& corner : corners) {
    top = std::min(top, corner.y());
    bottom = std::max(bottom, corner.y());
  }
  std::uint64_t pixels = 0;
  for (double row = std::ceil(top); row <= bottom; row += 1.0) {
    double left = kInfinity;
    double right = -kInfinity;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d& a = corners[i];
      const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
      if (row < std::min(a.y(), b.y()) || row > std::max(a.y(), b.y()) || a.y() == b.y()) continue;
      const double column = a.x() + (b.x() - a.x()) * ((row - a.y()) / (b.y() - a.y()));
      left = std::min(left, column);
      right = std::max(right, column);
    }
    if (left <= right) pixels += integersWithin(left, right);
  }
  return pixels;
}

}  // namespace mixed_palletizing::simulation
