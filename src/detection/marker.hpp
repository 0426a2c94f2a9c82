// ArUco markers in the colour of a cloud (thesis 2.5, 3.2.1 "Base-frame detection").
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>

namespace mixed_palletizing::detection {

struct PixelMarker {
  int id = 0;
  std::array<Eigen::Vector2d, 4> corners_px;  ///< column, row to a fraction of a pixel; in OpenCV's order
};

/// All markers of the dictionary, those with the wanted id first. With `inverted` the negative of the image
/// is searched too: a Zivid has no data on black ink, so markers are printed white on black. Throws
/// std::invalid_argument for a cloud without colour or an unknown dictionary.
std::vector<PixelMarker> detectMarkers(const geometry::CloudView& cloud, const MarkerOptions& options);

}  // namespace mixed_palletizing::detection
