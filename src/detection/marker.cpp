#include "marker.hpp"

#include <algorithm>
#include <stdexcept>

#include <opencv2/aruco.hpp>

#include "corner_refinement.hpp"
#include "marker_dictionary.hpp"

namespace mixed_palletizing::detection {
namespace {

using Corners = std::vector<cv::Point2f>;

cv::Mat grayImage(const geometry::CloudView& cloud) {
  cv::Mat gray(cloud.height, cloud.width, CV_8U);
  for (int row = 0; row < cloud.height; ++row) {
    std::uint8_t* out = gray.ptr<std::uint8_t>(row);
    for (int col = 0; col < cloud.width; ++col) {
      const std::uint8_t* bgr = cloud.bgr(row, col);
      out[col] = static_cast<std::uint8_t>((29 * bgr[0] + 150 * bgr[1] + 77 * bgr[2]) >> 8);
    }
  }
  return gray;
}

PixelMarker toMarker(int id, const Corners& corners) {
  PixelMarker marker;
  marker.id = id;
  for (std::size_t i = 0; i < 4; ++i) {
    marker.corners_px[i] =
        Eigen::Vector2d(static_cast<double>(corners[i].x), static_cast<double>(corners[i].y));
  }
  return marker;
}

/// True for a marker that is already listed: some are found in the image and in its negative.
bool listed(const std::vector<PixelMarker>& markers, const PixelMarker& marker) {
  return std::any_of(markers.begin(), markers.end(), [&](const PixelMarker& other) {
    return other.id == marker.id && (other.corners_px[0] - marker.corners_px[0]).norm() < 5.0;
  });
}

void addMarkers(const cv::Mat& gray, const cv::Ptr<cv::aruco::Dictionary>& dictionary,
                std::vector<PixelMarker>& markers) {
  const cv::Ptr<cv::aruco::DetectorParameters> parameters = cv::aruco::DetectorParameters::create();
  // A marker near the camera is large: wider windows than OpenCV's, up to some cells of it.
  parameters->adaptiveThreshWinSizeMax = 63;
  parameters->adaptiveThreshWinSizeStep = 20;
  // The edge of the paper is not the same candidate as the marker's border, however narrow the quiet zone.
  parameters->minMarkerDistanceRate = 0.01;
  std::vector<Corners> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(gray, dictionary, corners, ids, parameters);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    PixelMarker marker = toMarker(ids[i], corners[i]);
    refineCorners(gray, dictionary->markerSize + 2, marker.corners_px);
    if (!listed(markers, marker)) markers.push_back(marker);
  }
}

}  // namespace

std::vector<PixelMarker> detectMarkers(const geometry::CloudView& cloud, const MarkerOptions& options) {
  if (!cloud.hasColor()) throw std::invalid_argument("detectMarkers: cloud: no colour");
  const auto number = dictionaryNumber(options.dictionary);
  if (!number) {
    throw std::invalid_argument("detectMarkers: dictionary: '" + options.dictionary +
                                "' is unknown to OpenCV");
  }
  const auto dictionary = cv::aruco::getPredefinedDictionary(*number);
  cv::Mat gray = grayImage(cloud);
  std::vector<PixelMarker> markers;
  addMarkers(gray, dictionary, markers);
  if (options.inverted) {
    cv::bitwise_not(gray, gray);
    addMarkers(gray, dictionary, markers);
  }
  std::stable_partition(markers.begin(), markers.end(),
                        [&](const PixelMarker& marker) { return marker.id == options.id; });
  return markers;
}

}  // namespace mixed_palletizing::detection
