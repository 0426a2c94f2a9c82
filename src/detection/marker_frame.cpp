#include "marker_frame.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include <opencv2/core.hpp>

#include "board_fit.hpp"
#include "gray_image.hpp"
#include "marker.hpp"
#include "marker_dictionary.hpp"
#include "marker_fit.hpp"
#include "plane_map.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr int kLeastMargin_px = 20;       // of the window around a marker whose rays are fitted
constexpr double kLargestMargin = 2.0;    // marker sizes
constexpr std::size_t kSurface = 100;     // points that tell the height of a marker's surface
constexpr double kSideTolerance = 0.05;   // of a known side
constexpr double kSurfaceReach_m = 0.05;  // a marker's surface is nearer to the floor

PixelWindow whole(const geometry::CloudView& cloud) { return {0, 0, cloud.width, cloud.height}; }

/// The marker's surroundings, a margin [px] around its corners.
PixelWindow windowAround(const geometry::CloudView& cloud, const PixelMarker& marker, int margin) {
  Eigen::Vector2d low = marker.corners_px[0];
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& corner : marker.corners_px) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return {std::clamp(static_cast<int>(low.x()) - margin, 0, cloud.width),
          std::clamp(static_cast<int>(low.y()) - margin, 0, cloud.height),
          std::clamp(static_cast<int>(high.x()) + margin + 1, 0, cloud.width),
          std::clamp(static_cast<int>(high.y()) + margin + 1, 0, cloud.height)};
}

/// Rays of a growing window around the marker: there may be no data on all of its ink.
std::optional<LensRays> raysAround(const geometry::CloudView& cloud, const PixelMarker& marker) {
  const double size = (marker.corners_px[2] - marker.corners_px[0]).norm();
  for (int margin = kLeastMargin_px;; margin *= 2) {
    if (auto rays = LensRays::fit(cloud, windowAround(cloud, marker, margin))) return rays;
    if (margin > kLeastMargin_px + kLargestMargin * size) return std::nullopt;
  }
}

bool inside(const std::array<Eigen::Vector2d, 4>& corners, const Eigen::Vector2d& p) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d side = corners[(i + 1) % 4] - corners[i];
    const Eigen::Vector2d d = p - corners[i];
    if (side.x() * d.y() - side.y() * d.x() < 0.0) return false;  // clockwise as seen, rows point down
  }
  return true;
}

/// Median distance of the marker's points from the floor; 0 where there are too few to tell.
double surfaceHeight(const geometry::CloudView& cloud, const geometry::Plane& floor,
                     const PixelMarker& marker) {
  const PixelWindow window = windowAround(cloud, marker, 0);
  std::vector<double> heights;
  for (int row = window.row_begin; row < window.row_end; ++row) {
    for (int col = window.col_begin; col < window.col_end; ++col) {
      const Eigen::Vector3f p = cloud.point(row, col);
      if (!(p.z() > 0.0f) || !p.allFinite() || !inside(marker.corners_px, Eigen::Vector2d(col, row)))
        continue;
      const double height = floor.signedDistance(p.cast<double>());
      if (std::abs(height) < kSurfaceReach_m) heights.push_back(height);
    }
  }
  if (heights.size() < kSurface) return 0.0;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return *middle;
}

/// A marker and where it is in the axes of the floor.
struct Located {
  MarkerSighting sighting;
  PlaneMarker on_floor;
};

std::optional<Located> locate(const geometry::CloudView& cloud, const cv::Mat& gray,
                              const geometry::Plane& floor, const PixelMarker& marker,
                              const MarkerOptions& options) {
  const auto rays = raysAround(cloud, marker);
  if (!rays) return std::nullopt;
  const double height = surfaceHeight(cloud, floor, marker);
  // The surface that carries the marker, parallel to the floor: its axes stand above those of the floor.
  const PlaneMap map{PlaneAxes({floor.normal, floor.offset - height}), *rays};
  auto placed = placeMarker(map, marker);
  if (!placed) return std::nullopt;
  fitMarker(gray, map, markerCells(options.dictionary, marker.id), marker.inverted, *placed);
  if (options.side_m > 0.0 && std::abs(placed->side_m - options.side_m) > kSideTolerance * options.side_m) {
    return std::nullopt;
  }
  Located located;
  located.on_floor = *placed;
  located.sighting.id = marker.id;
  located.sighting.side_m = placed->side_m;
  located.sighting.height_m = height;
  located.sighting.rms_m = placed->rms_m;
  const auto corners = placed->corners();
  for (std::size_t i = 0; i < 4; ++i) {
    located.sighting.corners[i] = map.axes.inCamera(corners[i]);
    const auto pixel = map.pixel(corners[i]);
    if (!pixel) return std::nullopt;
    located.sighting.corners_px[i] = *pixel;
  }
  return located;
}

std::string notSeen(const MarkerOptions& options, const std::vector<PixelMarker>& seen) {
  std::ostringstream message;
  if (options.board.empty()) {
    message << "marker " << options.id << " of " << options.dictionary << " not seen; ";
  } else {
    message << "no marker of the board, of " << options.dictionary << ", seen; ";
  }
  if (seen.empty()) {
    message << "no marker of that dictionary is in the image";
    return message.str();
  }
  message << "seen:";
  for (const PixelMarker& marker : seen) message << ' ' << marker.id;
  return message.str();
}

/// The wanted places in the order of their ids; one at the origin without a board.
std::vector<BoardMarker> wantedPlaces(const MarkerOptions& options) {
  if (!options.board.empty()) return options.board;
  BoardMarker only;
  only.id = options.id;
  return {only};
}

}  // namespace

geometry::Pose floorFrame(const PlaneAxes& axes, const Eigen::Vector2d& origin, double yaw_rad) {
  Eigen::Matrix3d camera_from_base;
  camera_from_base.col(0) = std::cos(yaw_rad) * axes.x + std::sin(yaw_rad) * axes.y;
  camera_from_base.col(2) = axes.plane.normal;
  camera_from_base.col(1) = camera_from_base.col(2).cross(camera_from_base.col(0));
  geometry::Pose camera_pose = geometry::Pose::Identity();
  camera_pose.linear() = camera_from_base;
  camera_pose.translation() = axes.inCamera(origin);
  return camera_pose.inverse();
}

std::vector<std::array<Eigen::Vector2d, 4>> seenMarkers(const geometry::CloudView& cloud,
                                                        const geometry::Plane& floor,
                                                        const MarkerOptions& options) {
  std::vector<std::array<Eigen::Vector2d, 4>> corners;
  const auto rays = LensRays::fit(cloud, whole(cloud));
  if (!rays || !cloud.hasColor()) return corners;
  const std::vector<int> wanted = wantedIds(options);
  for (const PixelMarker& marker :
       detectMarkers(grayImage(cloud), PlaneMap{PlaneAxes(floor), *rays}, options)) {
    if (std::find(wanted.begin(), wanted.end(), marker.id) != wanted.end())
      corners.push_back(marker.corners_px);
  }
  return corners;
}

std::string placeOnMarkers(const geometry::CloudView& cloud, const DetectionOptions& options,
                           BaseFrame& frame) {
  if (!cloud.hasColor()) return "the cloud has no colour to look for a marker in";
  const PlaneAxes axes(frame.floor);
  const auto rays = LensRays::fit(cloud, whole(cloud));
  if (!rays) return "the points with data are too few to know the camera's rays";
  const cv::Mat gray = grayImage(cloud);
  const std::vector<PixelMarker> seen = detectMarkers(gray, PlaneMap{axes, *rays}, options.marker);
  const std::vector<BoardMarker> wanted = wantedPlaces(options.marker);
  std::vector<Located> used;
  std::vector<PlaneMarker> on_floor;
  std::vector<BoardMarker> places;
  std::vector<MarkerSighting> others;
  bool wanted_seen = false;
  for (const PixelMarker& marker : seen) {
    const auto place =
        std::find_if(wanted.begin(), wanted.end(), [&](const BoardMarker& w) { return w.id == marker.id; });
    wanted_seen = wanted_seen || place != wanted.end();
    const auto located = locate(cloud, gray, frame.floor, marker, options.marker);
    if (!located) continue;
    const bool again =
        std::any_of(used.begin(), used.end(), [&](const Located& l) { return l.sighting.id == marker.id; });
    if (place == wanted.end() || again) {
      others.push_back(located->sighting);
      continue;
    }
    used.push_back(*located);
    on_floor.push_back(located->on_floor);
    places.push_back(*place);
  }
  if (!wanted_seen) return notSeen(options.marker, seen);
  if (used.empty()) {
    return "marker " + std::to_string(wanted.front().id) +
           " is seen, but not as a square on the floor with measured points around it";
  }
  const BoardFit fit = fitBoard(on_floor, places);
  if (fit.worst_m > options.marker.max_board_error_m) {
    std::ostringstream message;
    message << "marker " << fit.worst_id << " lies " << 1000.0 * fit.worst_m
            << " mm from its place on the board, more than " << 1000.0 * options.marker.max_board_error_m
            << " mm";
    return message.str();
  }
  for (const Located& located : used) frame.markers.push_back(located.sighting);
  frame.markers.insert(frame.markers.end(), others.begin(), others.end());
  frame.markers_used = used.size();
  frame.board_rms_m = fit.rms_m;
  frame.base_from_camera = floorFrame(axes, fit.origin, fit.yaw_rad);
  return "";
}

}  // namespace mixed_palletizing::detection
