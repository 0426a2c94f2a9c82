// Where a grey image steps from dark to bright, to a small fraction of a pixel.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace cv {
class Mat;
}

namespace mixed_palletizing::detection {

struct GrayStep {
  double place_px = 0.0;  ///< along the direction
  double rise = 0.0;      ///< grey values from its near to its far end: positive when it becomes brighter
};

/// Step across `at` along the unit vector `direction`, looked for within +-reach [px]: where the area under the
/// profile would be that of a sharp step between its two end levels. Nothing at the border of the image and where
/// the levels differ by little.
std::optional<GrayStep> findGrayStep(const cv::Mat& gray, const Eigen::Vector2d& at,
                                     const Eigen::Vector2d& direction, double reach);

}  // namespace mixed_palletizing::detection
