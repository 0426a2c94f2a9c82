// The printed picture of a marker.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

/// Number of markers in a dictionary of OpenCV's aruco module; 0 when it has no dictionary of that name.
int markerCount(const std::string& dictionary);

/// Black and white of the paper, the quiet zone included.
class MarkerPicture {
 public:
  /// Throws std::invalid_argument for an unknown dictionary or id.
  explicit MarkerPicture(const Marker& marker);

  /// Side of the square paper [m].
  double paperSide() const { return side_m_ + 2.0 * quiet_zone_m_; }

  /// Whether the ink at (x, y) [m], in the marker's frame, is white; nothing outside the paper.
  std::optional<bool> isWhite(double x, double y) const;

 private:
  double side_m_;
  double quiet_zone_m_;
  bool quiet_zone_white_;
  int cells_ = 0;  // along a side, the border included
  std::vector<std::uint8_t> white_;
};

}  // namespace mixed_palletizing::simulation
