#include "marker.hpp"

#include <algorithm>
#include <stdexcept>

#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

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

double shortestSide(const Corners& corners) {
  double shortest = cv::norm(corners[0] - corners[3]);
  for (std::size_t i = 1; i < 4; ++i) shortest = std::min(shortest, cv::norm(corners[i] - corners[i - 1]));
  return shortest;
}

/// Moves the corners to where the gradients meet; the window stays inside one cell of the marker.
void refineCorners(const cv::Mat& gray, int cells, Corners& corners) {
  const int half = std::clamp(static_cast<int>(0.5 * shortestSide(corners) / cells), 1, 7);
  const cv::TermCriteria stop(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.005);
  cv::cornerSubPix(gray, corners, cv::Size(half, half), cv::Size(-1, -1), stop);
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
  std::vector<Corners> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(gray, dictionary, corners, ids);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    refineCorners(gray, dictionary->markerSize + 2, corners[i]);
    const PixelMarker marker = toMarker(ids[i], corners[i]);
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
  const auto dictionary =
      cv::aruco::getPredefinedDictionary(static_cast<cv::aruco::PREDEFINED_DICTIONARY_NAME>(*number));
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
