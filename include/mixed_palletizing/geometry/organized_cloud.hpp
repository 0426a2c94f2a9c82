// An organized cloud that owns its points, in the 16-byte layout of the camera driver.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <mixed_palletizing/geometry/cloud_view.hpp>

namespace mixed_palletizing::geometry {

/// x, y, z [m] in the optical frame and colour as 0xAARRGGBB; NaN coordinates mean no data.
struct ColoredPoint {
  float x = std::numeric_limits<float>::quiet_NaN();
  float y = std::numeric_limits<float>::quiet_NaN();
  float z = std::numeric_limits<float>::quiet_NaN();
  std::uint32_t rgba = 0xff000000u;
};
static_assert(sizeof(ColoredPoint) == 16, "the driver's layout has 16 bytes a point");

struct OrganizedCloud {
  int width = 0;
  int height = 0;
  bool has_color = true;
  std::vector<ColoredPoint> points;  ///< row-major, width * height

  /// View of the points; valid while `points` is neither resized nor destroyed.
  CloudView view() const;
};

}  // namespace mixed_palletizing::geometry
