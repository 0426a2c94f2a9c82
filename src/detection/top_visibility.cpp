#include "top_visibility.hpp"

#include <algorithm>
#include <cmath>

#include <mixed_palletizing/geometry/polygon.hpp>

#include "pixel_rays.hpp"

namespace mixed_palletizing::detection {

double topVisibility(const BaseCloud& cloud, const geometry::Pose& base_from_camera, const RunRange& top,
                     const geometry::Rectangle& rectangle, double height_m) {
  PixelRays rays;
  std::size_t count = 0;
  for (const Run& run : top) {
    // The ends of the runs span the top; the points between them add nothing to a linear model.
    rays.add(run.begin, run.row, cloud.view().point(run.row, run.begin));
    rays.add(run.end - 1, run.row, cloud.view().point(run.row, run.end - 1));
    count += static_cast<std::size_t>(run.size());
  }
  if (!rays.fit()) return 0.0;
  const geometry::Pose camera_from_base = base_from_camera.inverse();
  geometry::Polygon image;
  for (const Eigen::Vector2d& corner : rectangle.corners()) {
    const auto pixel = rays.pixel(camera_from_base * Eigen::Vector3d(corner.x(), corner.y(), height_m));
    if (!pixel) return 0.0;
    image.push_back(*pixel);
  }
  return std::min(1.0, static_cast<double>(count) / std::max(1.0, std::abs(geometry::signedArea(image))));
}

}  // namespace mixed_palletizing::detection
