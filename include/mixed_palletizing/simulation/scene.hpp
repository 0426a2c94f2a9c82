// A scene: floor, surfaces, markers, boxes and other objects, and the camera that looks at them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/pose.hpp>
#include <mixed_palletizing/simulation/camera.hpp>
#include <mixed_palletizing/simulation/scene_box.hpp>
#include <mixed_palletizing/simulation/scene_object.hpp>

namespace mixed_palletizing::simulation {

/// World frame: z up, floor at z = 0; the marker's centre is usually the origin, so that the world is the
/// base frame. Colours are 0xRRGGBB.
struct Floor {
  double size_x_m = 4.0;  ///< the floor is a rectangle around the origin
  double size_y_m = 4.0;
  std::uint32_t rgb = 0x6e6e6e;
  std::shared_ptr<const Texture> texture;  ///< over the whole floor, its picture's top towards +y
};

struct Marker {
  std::string dictionary = "DICT_4X4_50";  ///< as OpenCV's aruco module names it
  int id = 0;
  double side_m = 0.15;        ///< outer side of the black (inverted: white) border
  double quiet_zone_m = 0.02;  ///< paper around the border: white (inverted: black)
  bool inverted = true;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< of the centre on its surface
  double yaw_rad = 0.0;                                  ///< direction from corner 0 to corner 1
  std::string surface;                                   ///< name of the surface it lies on; empty: the floor
};

/// Markers on one sheet of paper, ids row by row from the picture's top left, as OpenCV's GridBoard has them.
struct MarkerBoard {
  Marker first;  ///< dictionary, look and lowest id of all; position and yaw are the board's centre's
  int columns = 4;
  int rows = 3;
  double gap_m = 0.03;  ///< between markers
};

/// What the sensor does to the ideal cloud; everything is off by default.
struct Noise {
  double depth_stddev_at_1m_m =
      0.0;                        ///< Gaussian of the depth, growing with the depth squared; along the ray
  bool no_data_on_black = false;  ///< dark ink (luma below 0.2) gives NaN, as with structured light
  double dropout_ratio = 0.0;     ///< share of pixels without data at random
  double flying_pixel_ratio =
      0.0;                     ///< share of the pixels beside a depth edge that lie between its two sides
  double depth_edge_m = 0.02;  ///< least difference of depth between neighbours that makes an edge
  /// The depth's standard deviation is multiplied by 1 + dark_noise_gain * (1 - luma of the paint) and by
  /// 1 + grazing_noise_gain * (1 / cosine - 1), cosine (at least 0.05) of the angle between ray and surface normal.
  double dark_noise_gain = 0.0;
  double grazing_noise_gain = 0.0;
};

struct Scene {
  Floor floor;
  bool has_marker = true;
  Marker marker;                ///< the base frame's, on the floor
  std::vector<Marker> markers;  ///< more of them
  std::vector<MarkerBoard> boards;
  std::vector<SceneSurface> surfaces;
  std::vector<SceneBox> boxes;
  std::vector<SceneObject> objects;
  Camera camera;
  Noise noise;
};

/// Frame of a surface: in the middle of its upper side, z up; empty: of the floor. Throws std::invalid_argument for
/// a name that the scene has not.
geometry::Pose worldFromSurface(const Scene& scene, const std::string& surface);

/// Frame at the centre of a marker on the floor, z up, x from corner 0 to corner 1: the base frame that a detector
/// should find.
geometry::Pose worldFromMarker(const Marker& marker);

/// Outer corners of a marker on the floor in the world, in OpenCV's order (clockwise from the picture's top left).
std::array<Eigen::Vector3d, 4> markerCorners(const Marker& marker);

/// Every single marker of a board, placed on its surface.
std::vector<Marker> markersOf(const MarkerBoard& board);

/// Every broken rule as one line "key: what is wrong", keys as in a scene file (without the units of angles).
/// Boxes must not overlap (0.1 mm is allowed), no box may lie below the floor, and nothing may hold the camera.
std::vector<std::string> problems(const Scene& scene);

/// What is likely a mistake, as lines "key: what": objects and surfaces that reach into one another, into a box or
/// below the floor by more than 1 mm. Flaps of boxes do not count. The scene must have no problems.
std::vector<std::string> warnings(const Scene& scene);

}  // namespace mixed_palletizing::simulation
