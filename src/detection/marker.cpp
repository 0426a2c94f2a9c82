#include "marker.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>

#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "gray_image.hpp"
#include "marker_dictionary.hpp"

namespace mixed_palletizing::detection {
namespace {

using Dictionary = cv::Ptr<cv::aruco::Dictionary>;
using Corners = std::vector<cv::Point2f>;
/// Place in the searched image of a place in an image made from it.
using Back = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

constexpr double kSamePlace_px = 5.0;
constexpr int kEnlarge = 2;
constexpr std::size_t kLargestPicture = 12'000'000;  // pixels that are worth enlarging to
constexpr int kViewSide = 2000;                      // pixels of the view from above, at most
constexpr double kViewReach = 2.5;                   // its half side, in heights of the camera

cv::Ptr<cv::aruco::DetectorParameters> searchParameters() {
  const cv::Ptr<cv::aruco::DetectorParameters> parameters = cv::aruco::DetectorParameters::create();
  // A marker near the camera is large: wider windows than OpenCV's, up to some cells of it.
  parameters->adaptiveThreshWinSizeMax = 63;
  parameters->adaptiveThreshWinSizeStep = 20;
  // The edge of the paper is not the same candidate as the marker's border, however narrow the quiet zone.
  parameters->minMarkerDistanceRate = 0.01;
  parameters->minMarkerPerimeterRate = 0.015;  // down to the smallest that can be read
  parameters->perspectiveRemovePixelPerCell = 8;
  return parameters;
}

/// True for a marker that is already listed: some are found in the image and in its negative.
bool listed(const std::vector<PixelMarker>& markers, const PixelMarker& marker) {
  return std::any_of(markers.begin(), markers.end(), [&](const PixelMarker& other) {
    return other.id == marker.id && (other.corners_px[0] - marker.corners_px[0]).norm() < kSamePlace_px;
  });
}

bool allFound(const std::vector<PixelMarker>& markers, const std::vector<int>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](int id) {
    return std::any_of(markers.begin(), markers.end(), [&](const PixelMarker& m) { return m.id == id; });
  });
}

void search(const cv::Mat& gray, const Dictionary& dictionary, bool inverted, const Back& back,
            std::vector<PixelMarker>& markers) {
  std::vector<Corners> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(gray, dictionary, corners, ids, searchParameters());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    PixelMarker marker;
    marker.id = ids[i];
    marker.inverted = inverted;
    for (std::size_t k = 0; k < 4; ++k) {
      marker.corners_px[k] =
          back({static_cast<double>(corners[i][k].x), static_cast<double>(corners[i][k].y)});
    }
    if (!listed(markers, marker)) markers.push_back(marker);
  }
}

void searchBothInks(const cv::Mat& gray, const Dictionary& dictionary, bool inverted, const Back& back,
                    std::vector<PixelMarker>& markers) {
  search(gray, dictionary, false, back, markers);
  if (!inverted) return;
  cv::Mat negative;
  cv::bitwise_not(gray, negative);
  search(negative, dictionary, true, back, markers);
}

/// The floor as seen from straight above, and the pixels of `gray` that it is made of (row-major 3 x 3 homography).
struct ViewFromAbove {
  cv::Mat picture;
  cv::Matx33d gray_from_picture;
};

std::optional<ViewFromAbove> viewFromAbove(const cv::Mat& gray, const PlaneMap& floor) {
  // The square of floor around the place in the middle of the image.
  const auto middle = floor.point({0.5 * gray.cols, 0.5 * gray.rows});
  if (!middle) return std::nullopt;
  const double height = floor.axes.origin.norm();
  const double half = std::min(kViewReach * height, 0.5 * middle->norm() + height);
  std::vector<cv::Point2f> from;
  std::vector<cv::Point2f> to;
  const double metres_per_px = 2.0 * half / kViewSide;
  for (const auto& corner : {Eigen::Vector2d(-0.2, -0.2), Eigen::Vector2d(0.2, -0.2),
                             Eigen::Vector2d(0.2, 0.2), Eigen::Vector2d(-0.2, 0.2)}) {
    // A small square around the middle is in front of the camera at every tilt.
    const Eigen::Vector2d point = *middle + corner * height;
    const auto pixel = floor.pixel(point);
    if (!pixel) return std::nullopt;
    const Eigen::Vector2d at = (point - *middle) / metres_per_px;
    // Rows run against the plane's y axis: the picture shows what the camera sees, not its mirror image.
    from.emplace_back(static_cast<float>(0.5 * kViewSide + at.x()),
                      static_cast<float>(0.5 * kViewSide - at.y()));
    to.emplace_back(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()));
  }
  ViewFromAbove view;
  view.gray_from_picture = cv::Matx33d(cv::getPerspectiveTransform(from, to).ptr<double>());
  cv::warpPerspective(gray, view.picture, cv::Mat(view.gray_from_picture), cv::Size(kViewSide, kViewSide),
                      cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, cv::Scalar(128));
  return view;
}

void searchFromAbove(const cv::Mat& gray, const PlaneMap& floor, const Dictionary& dictionary, bool inverted,
                     std::vector<PixelMarker>& markers) {
  const auto view = viewFromAbove(gray, floor);
  if (!view) return;
  const Back back = [&](const Eigen::Vector2d& p) {
    const cv::Vec3d q = view->gray_from_picture * cv::Vec3d(p.x(), p.y(), 1.0);
    return Eigen::Vector2d(q[0] / q[2], q[1] / q[2]);
  };
  searchBothInks(view->picture, dictionary, inverted, back, markers);
}

void searchEnlarged(const cv::Mat& gray, const Dictionary& dictionary, bool inverted,
                    std::vector<PixelMarker>& markers) {
  if (gray.total() * kEnlarge * kEnlarge > kLargestPicture) return;
  cv::Mat large;
  cv::resize(gray, large, cv::Size(), kEnlarge, kEnlarge, cv::INTER_CUBIC);
  const Back back = [](const Eigen::Vector2d& p) {
    return Eigen::Vector2d((p.array() + 0.5) / static_cast<double>(kEnlarge) - 0.5);
  };
  searchBothInks(large, dictionary, inverted, back, markers);
}

}  // namespace

std::vector<int> wantedIds(const MarkerOptions& options) {
  if (options.board.empty()) return {options.id};
  std::vector<int> ids;
  for (const BoardMarker& marker : options.board) ids.push_back(marker.id);
  return ids;
}

std::vector<PixelMarker> detectMarkers(const cv::Mat& gray, const PlaneMap& floor,
                                       const MarkerOptions& options) {
  const auto number = dictionaryNumber(options.dictionary);
  if (!number) {
    throw std::invalid_argument("detectMarkers: dictionary: '" + options.dictionary +
                                "' is unknown to OpenCV");
  }
  const Dictionary dictionary = cv::aruco::getPredefinedDictionary(*number);
  const std::vector<int> wanted = wantedIds(options);
  const Back same = [](const Eigen::Vector2d& p) { return p; };
  std::vector<PixelMarker> markers;
  searchBothInks(gray, dictionary, options.inverted, same, markers);
  if (!allFound(markers, wanted))
    searchBothInks(evenContrast(gray), dictionary, options.inverted, same, markers);
  if (!allFound(markers, wanted)) searchEnlarged(gray, dictionary, options.inverted, markers);
  if (!allFound(markers, wanted)) searchFromAbove(gray, floor, dictionary, options.inverted, markers);
  return markers;
}

}  // namespace mixed_palletizing::detection
