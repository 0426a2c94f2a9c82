// The base frame of a camera as a YAML file.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/geometry/plane.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::adapters {

struct Calibration {
  std::string base_frame;    ///< name of the frame z up, on the floor; may be empty
  std::string camera_frame;  ///< name of the optical frame it is seen from; may be empty
  geometry::Pose base_from_camera = geometry::Pose::Identity();
  std::vector<geometry::Plane> removed_planes;  ///< base frame; no places of boxes (plane.remove)
};

/// Writes
///
///   base_frame: aruco_base
///   camera_frame: zivid_optical_frame
///   base_from_camera:          # rows of the 4 x 4 matrix [m]
///     - [r, r, r, x]
///     ...
///   removed_planes: [nx, ny, nz, offset, ...]  # four numbers for each; may be missing
///
/// replacing the file in one step. Throws std::runtime_error "PATH: reason" when it cannot be written.
void writeCalibration(const std::string& path, const Calibration& calibration);

/// Reads such a file; the frames may be missing. Throws std::runtime_error "PATH: reason" when it cannot be
/// read, has unknown keys, or when the matrix is no rigid transform (to a thousandth; smaller errors of
/// rounding are mended).
Calibration readCalibration(const std::string& path);

}  // namespace mixed_palletizing::adapters
