// A marker on a plane, fitted to all edges between its black and white cells.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "marker.hpp"
#include "plane_map.hpp"

namespace cv {
class Mat;
}

namespace mixed_palletizing::detection {

/// A square marker on a plane in that plane's coordinates [m].
struct PlaneMarker {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;  ///< direction from corner 0 to corner 1
  double side_m = 0.0;
  double rms_m = 0.0;      ///< of the edges from the fitted picture; 0 when the corners alone were used
  std::size_t places = 0;  ///< on the edges that the fit used

  /// The corners in OpenCV's order, clockwise as the camera sees them.
  std::array<Eigen::Vector2d, 4> corners() const;
};

/// The marker at the places where the rays of its corners meet the plane; nothing when they are not about a square
/// there, which is what things that look like a marker by chance are not.
std::optional<PlaneMarker> placeMarker(const PlaneMap& map, const PixelMarker& marker);

/// Improves `marker`: at every pixel along every edge between a black and a white cell the step is looked for in the
/// image, carried onto the plane by its viewing ray, and centre, yaw and side are fitted to all of them robustly
/// (four unknowns, some thousand places). Edges inside the picture lie at other fractions of a pixel than its border,
/// so that the pixel grid cancels out. `white`: cells row by row, border included.
/// Leaves the marker as it is when the cells are smaller than some pixels or too faint.
void fitMarker(const cv::Mat& gray, const PlaneMap& map, const std::vector<bool>& white, bool inverted,
               PlaneMarker& marker);

}  // namespace mixed_palletizing::detection
