// The base frame from one or several clouds: floor plane, and on it a marker or the foot of the camera.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/plane.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {

enum class BaseFrameSource {
  kMarker,  ///< origin at the marker's centre, x from corner 0 to corner 1, z = floor normal
  kFloor,   ///< origin at the foot of the camera's perpendicular, x = the camera's x projected on the floor
};

struct MarkerSighting {
  int id = 0;
  std::array<Eigen::Vector2d, 4> corners_px;  ///< column, row; in OpenCV's order
  std::array<Eigen::Vector3d, 4> corners;     ///< camera frame [m]
  double side_m = 0.0;                        ///< as measured
  double height_m = 0.0;                      ///< of its surface above the floor: paper, plate
  double rms_m = 0.0;  ///< of its black and white edges from the picture; 0: not fitted
};

/// A plane beside the floor: table, conveyor, wall, the top of a large box.
struct FoundPlane {
  geometry::Plane plane;  ///< base frame, the normal points to the camera's side
  geometry::Pose base_from_plane =
      geometry::Pose::Identity();  ///< origin in the middle of its points, z = normal
  std::size_t inliers = 0;
  double rms_m = 0.0;
};

struct BaseFrame {
  geometry::Pose base_from_camera = geometry::Pose::Identity();
  geometry::Plane floor;  ///< camera frame, the normal points to the camera's side (up)
  std::size_t plane_inliers = 0;
  double plane_rms_m = 0.0;
  std::vector<FoundPlane> planes;       ///< beside the floor, the largest first
  std::vector<MarkerSighting> markers;  ///< all that were seen, the used ones first
  std::size_t markers_used = 0;
  double board_rms_m = 0.0;  ///< of the used markers' corners from their places on the board
};

/// Outcome of looking for the base frame: a frame, or a message that says what was seen instead.
struct BaseFrameResult {
  std::optional<BaseFrame> frame;
  std::string message;
};

/// Base frame from one cloud (thesis 3.2.1: eq. 3.4, 3.6, 3.7). The marker source needs colour in the cloud.
BaseFrameResult findBaseFrame(const geometry::CloudView& cloud, BaseFrameSource source,
                              const DetectionOptions& options);

/// Those of the frame's planes that are no places of boxes, for RegionOptions::planes.
std::vector<geometry::Plane> removedPlanes(const BaseFrame& frame, RemovedPlanes which);

struct AveragedBaseFrame {
  BaseFrame frame;          ///< mean pose; plane and markers of the first cloud, summed inliers, mean rms
  double spread_m = 0.0;    ///< largest distance of one origin from the mean origin
  double spread_rad = 0.0;  ///< largest angle of one orientation from the mean orientation
};

/// Mean of the frames found in several clouds of the same scene. Throws std::invalid_argument when empty.
AveragedBaseFrame averageBaseFrames(const std::vector<BaseFrame>& frames);

}  // namespace mixed_palletizing::detection
