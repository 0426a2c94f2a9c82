// A scene of a floor, a marker and boxes, and the camera that looks at it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::simulation {

/// World frame: z up, floor at z = 0; the marker's centre is usually the origin, so that the world is the
/// base frame.
struct Floor {
  double size_x_m = 4.0;  ///< the floor is a rectangle around the origin
  double size_y_m = 4.0;
  std::uint32_t rgb = 0x6e6e6e;
};

struct Marker {
  std::string dictionary = "DICT_4X4_50";
  int id = 0;
  double side_m = 0.15;        ///< outer side of the black (inverted: white) border
  double quiet_zone_m = 0.02;  ///< paper around the border
  bool inverted = true;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< of the centre on the floor
  double yaw_rad = 0.0;                                  ///< direction from corner 0 to corner 1
};

struct SceneBox {
  std::string name;
  Eigen::Vector3d size_m = Eigen::Vector3d(0.3, 0.2, 0.15);  ///< along its own x, y, z
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();      ///< of the centre in the floor plane
  double base_z_m = 0.0;                                     ///< height of its underside
  double yaw_rad = 0.0;
  std::uint32_t rgb = 0xb08a5a;
};

/// Pinhole camera: optical frame x right, y down, z forward.
struct Camera {
  int width_px = 1920;
  int height_px = 1200;
  double horizontal_fov_rad = 0.6815;  ///< Zivid One: 780 mm wide at 1100 mm (thesis 2.1)
  geometry::Pose world_from_camera = geometry::Pose::Identity();
};

struct Noise {
  double depth_stddev_at_1m_m = 0.0;  ///< Gaussian along the ray's depth, growing with depth squared
  bool no_data_on_black = false;      ///< dark ink (luma below 0.2) gives NaN, as with structured light
  double dropout_ratio = 0.0;         ///< share of pixels without data at random
};

struct Scene {
  Floor floor;
  bool has_marker = true;
  Marker marker;
  std::vector<SceneBox> boxes;
  Camera camera;
  Noise noise;
};

/// Pose of a camera at `eye` looking at `target`, image up as near to world z as it can be (to world y when
/// the camera looks straight down). Throws std::invalid_argument when eye and target coincide.
geometry::Pose lookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const Scene& scene);

}  // namespace mixed_palletizing::simulation
