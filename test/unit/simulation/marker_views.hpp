// What OpenCV finds in the colours of a capture.
#pragma once

#include <cstring>
#include <vector>

#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include <mixed_palletizing/simulation/capture.hpp>

namespace mixed_palletizing::simulation {

inline cv::Mat grayOf(const Capture& capture) {
  cv::Mat bgra(capture.cloud.height, capture.cloud.width, CV_8UC4);
  cv::Mat gray;
  for (int row = 0; row < bgra.rows; ++row) {
    for (int col = 0; col < bgra.cols; ++col) {
      const std::uint32_t rgba =
          capture.cloud
              .points[static_cast<std::size_t>(row) * static_cast<std::size_t>(bgra.cols) +
                      static_cast<std::size_t>(col)]
              .rgba;
      std::memcpy(bgra.ptr(row, col), &rgba, sizeof rgba);
    }
  }
  cv::cvtColor(bgra, gray, cv::COLOR_BGRA2GRAY);
  return gray;
}

struct FoundMarkers {
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> corners;
};

inline FoundMarkers findMarkers(const Capture& capture, int dictionary, bool inverted) {
  FoundMarkers found;
  const cv::Ptr<cv::aruco::DetectorParameters> parameters = cv::aruco::DetectorParameters::create();
  parameters->detectInvertedMarker = inverted;
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  cv::aruco::detectMarkers(grayOf(capture), cv::aruco::getPredefinedDictionary(dictionary), found.corners,
                           found.ids, parameters);
  return found;
}

}  // namespace mixed_palletizing::simulation
