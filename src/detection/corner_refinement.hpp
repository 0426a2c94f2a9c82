// Corners of a marker to a small fraction of a pixel.
#pragma once

#include <array>

#include <Eigen/Core>

namespace cv {
class Mat;
}

namespace mixed_palletizing::detection {

/// Each side of the marker's border is a step from dark to bright or back. The step is looked for across the side
/// at many places along it, a line is fitted to the places robustly, and neighbouring lines are met. That uses
/// hundreds of pixels where a window around each corner uses a few. `cells`: of the marker along one side,
/// border included. Corners (column, row) whose sides are too short or too faint stay as they are.
void refineCorners(const cv::Mat& gray, int cells, std::array<Eigen::Vector2d, 4>& corners);

}  // namespace mixed_palletizing::detection
