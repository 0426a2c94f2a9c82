#include "floor_choice.hpp"

#include <algorithm>
#include <cmath>

#include "marker_frame.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kParallel = 0.94;      // cosine of the angle between normals: 20 degrees
constexpr double kMarkerMargin = 0.5;   // marker sizes around it whose points tell its plane
constexpr double kNearDistances = 3.0;  // inlier distances of a plane
constexpr std::size_t kFewestPoints = 50;

std::size_t lowest(const std::vector<PlaneFit>& planes) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < planes.size(); ++i) {
    if (planes[i].plane.normal.dot(planes[0].plane.normal) < kParallel) continue;
    if (std::abs(planes[i].plane.offset) > std::abs(planes[best].plane.offset)) best = i;
  }
  return best;
}

std::size_t nearestTo(const std::vector<PlaneFit>& planes, double camera_height_m) {
  const auto error = [&](const PlaneFit& fit) {
    return std::abs(std::abs(fit.plane.offset) - camera_height_m);
  };
  const auto best = std::min_element(planes.begin(), planes.end(), [&](const PlaneFit& a, const PlaneFit& b) {
    return error(a) < error(b);
  });
  return static_cast<std::size_t>(best - planes.begin());
}

/// Adds to `votes` the points in and around a marker that lie on each plane.
void vote(const geometry::CloudView& cloud, const std::array<Eigen::Vector2d, 4>& corners,
          const std::vector<PlaneFit>& planes, std::vector<std::size_t>& votes) {
  Eigen::Vector2d low = corners[0];
  Eigen::Vector2d high = corners[0];
  for (const Eigen::Vector2d& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Eigen::Vector2d margin = kMarkerMargin * (high - low);
  const int row_end = std::min(cloud.height, static_cast<int>(high.y() + margin.y()) + 1);
  const int col_end = std::min(cloud.width, static_cast<int>(high.x() + margin.x()) + 1);
  for (int row = std::max(0, static_cast<int>(low.y() - margin.y())); row < row_end; ++row) {
    for (int col = std::max(0, static_cast<int>(low.x() - margin.x())); col < col_end; ++col) {
      const Eigen::Vector3f p = cloud.point(row, col);
      if (!(p.z() > 0.0f) || !p.allFinite()) continue;
      for (std::size_t i = 0; i < planes.size(); ++i) {
        const double distance = std::abs(planes[i].plane.signedDistance(p.cast<double>()));
        if (distance < kNearDistances * planes[i].distance_m) ++votes[i];
      }
    }
  }
}

FloorChoiceResult markersFloor(const geometry::CloudView& cloud, const std::vector<PlaneFit>& planes,
                               const MarkerOptions& options) {
  FloorChoiceResult result;
  const auto seen = seenMarkers(cloud, planes.front().plane, options);
  if (seen.empty()) {
    result.message = "the floor is that of the marker, and no wanted marker is seen";
    return result;
  }
  std::vector<std::size_t> votes(planes.size(), 0);
  for (const auto& corners : seen) vote(cloud, corners, planes, votes);
  const auto best = std::max_element(votes.begin(), votes.end());
  if (*best < kFewestPoints) {
    result.message =
        "the marker lies on none of the " + std::to_string(planes.size()) + " planes that were found";
    return result;
  }
  result.floor = static_cast<std::size_t>(best - votes.begin());
  return result;
}

}  // namespace

FloorChoiceResult chooseFloor(const geometry::CloudView& cloud, const std::vector<PlaneFit>& planes,
                              const DetectionOptions& options) {
  switch (options.plane.floor) {
    case FloorChoice::kLowest:
      return {lowest(planes), ""};
    case FloorChoice::kCameraHeight:
      return {nearestTo(planes, options.plane.camera_height_m), ""};
    case FloorChoice::kMarker:
      return markersFloor(cloud, planes, options.marker);
    case FloorChoice::kLargest:
      break;
  }
  return {std::size_t{0}, ""};
}

}  // namespace mixed_palletizing::detection
