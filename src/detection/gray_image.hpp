// The colour of a cloud as a grey image in which markers can be looked for.
#pragma once

#include <opencv2/core.hpp>

#include <mixed_palletizing/geometry/cloud_view.hpp>

namespace mixed_palletizing::detection {

/// Luma of the colour channel, 8 bits, rows and columns of the cloud; also of points without data. Stretched so that
/// the darkest and the brightest thousandths of the pixels become 0 and 255, whatever the exposure. Throws
/// std::invalid_argument for a cloud without colour.
cv::Mat grayImage(const geometry::CloudView& cloud);

/// `gray` with the contrast of every part of the image evened out: for shadows and lamps in view.
cv::Mat evenContrast(const cv::Mat& gray);

}  // namespace mixed_palletizing::detection
