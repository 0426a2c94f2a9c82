#include <cstddef>

#include <mixed_palletizing/geometry/organized_cloud.hpp>

namespace mixed_palletizing::geometry {

CloudView OrganizedCloud::view() const {
  CloudView view;
  view.data = reinterpret_cast<const std::uint8_t*>(points.data());
  view.width = width;
  view.height = height;
  view.point_step = sizeof(ColoredPoint);
  view.row_step = sizeof(ColoredPoint) * static_cast<std::size_t>(width);
  view.x_offset = offsetof(ColoredPoint, x);
  view.y_offset = offsetof(ColoredPoint, y);
  view.z_offset = offsetof(ColoredPoint, z);
  view.color_offset = has_color ? offsetof(ColoredPoint, rgba) : CloudView::kNoColor;
  return view;
}

}  // namespace mixed_palletizing::geometry
