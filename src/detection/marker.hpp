// ArUco markers in a grey image (thesis 2.5, 3.2.1 "Base-frame detection").
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/detection/options.hpp>

#include "plane_map.hpp"

namespace cv {
class Mat;
}

namespace mixed_palletizing::detection {

struct PixelMarker {
  int id = 0;
  bool inverted = false;  ///< white border and black paper: a Zivid has no data on black ink
  std::array<Eigen::Vector2d, 4> corners_px;  ///< column, row to about a pixel; in OpenCV's order
};

/// Ids that the base frame is made of: those of the board, or the one marker.
std::vector<int> wantedIds(const MarkerOptions& options);

/// Markers of the dictionary, normal ones and, with `inverted`, those printed as the negative. As long as a wanted id
/// is missing the image is searched again: with its contrast evened out, enlarged, and seen from straight above the
/// floor, where a marker is a square however flat the camera looks at it. Throws std::invalid_argument for an unknown
/// dictionary.
std::vector<PixelMarker> detectMarkers(const cv::Mat& gray, const PlaneMap& floor,
                                       const MarkerOptions& options);

}  // namespace mixed_palletizing::detection
