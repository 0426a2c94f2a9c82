// The camera of a scene, and the models of the maker that there are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::simulation {

/// Focal lengths and principal point; the centre of pixel (row, col) has the image coordinates (col, row).
struct Intrinsics {
  double fx_px = 1.0;
  double fy_px = 1.0;
  double cx_px = 0.0;
  double cy_px = 0.0;
};

/// Pinhole camera without distortion: optical frame x right, y down, z forward.
struct Camera {
  int width_px = 1920;
  int height_px = 1200;
  double horizontal_fov_rad = 0.6815;  ///< Zivid One: 780 mm wide at 1100 mm (thesis 2.1)
  /// Instead of the field of view; without them pixels are square and the axis runs through the middle.
  std::optional<Intrinsics> intrinsics;
  geometry::Pose world_from_camera = geometry::Pose::Identity();
  /// Place of the projector in the camera's frame [m]: what it does not light has no data. Without it
  /// everything the camera sees is lit.
  std::optional<Eigen::Vector3d> projector_m;
};

/// What the maker says of a model; docs/scene_files.md names the sources.
struct CameraModel {
  std::string name;
  int width_px;
  int height_px;
  double field_width_m;  ///< width of what it sees ...
  double field_at_m;     ///< ... at this distance
  double nearest_m;      ///< working distances
  double farthest_m;
  Eigen::Vector3d projector_m;  ///< in the camera's frame
};

const std::vector<CameraModel>& cameraModels();

/// Camera of a model, with its projector, at the world's origin.
/// Throws std::invalid_argument for a name that cameraModels() does not have.
Camera cameraOfModel(const std::string& name);

/// The camera that delivers one point for every block of `step` x `step` pixels, in the middle of the block; rows
/// and columns that do not fill a block are cut off at the end. Throws std::invalid_argument unless step is 1, 2
/// or 4.
Camera subsampled(const Camera& camera, int step);

/// Pose of a camera at `eye` looking at `target`, image up as near to world z as it can be (to world y when
/// the camera looks straight down). Throws std::invalid_argument when eye and target coincide.
geometry::Pose lookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

}  // namespace mixed_palletizing::simulation
