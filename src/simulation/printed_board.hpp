// The printed picture of a board of markers.
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
class PrintedBoard {
 public:
  /// Throws std::invalid_argument for an unknown dictionary or id.
  explicit PrintedBoard(const MarkerBoard& board);

  const Eigen::Vector2d& paperSize() const { return paper_size_m_; }

  /// Whether the ink at (x, y) [m], in the board's frame, is white; nothing outside the paper.
  std::optional<bool> isWhite(double x, double y) const;

 private:
  int columns_;
  int rows_;
  double side_m_;
  double pitch_m_;  // from marker to marker
  bool paper_white_;
  Eigen::Vector2d markers_size_m_;  // without the quiet zone
  Eigen::Vector2d paper_size_m_;
  int cells_ = 0;                                 // along a side of a marker, the border included
  std::vector<std::vector<std::uint8_t>> white_;  // by marker
};

}  // namespace mixed_palletizing::simulation
