// A carton: its size, paint, and how it departs from a cuboid.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/pose.hpp>
#include <mixed_palletizing/simulation/texture.hpp>

namespace mixed_palletizing::simulation {

/// A painted rectangle on a box's top, given in the box's own x and y; with `down_sides` it runs down every
/// side of the box whose edge it reaches (a band of tape, a strip of dark print).
struct BoxLabel {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d size_m = Eigen::Vector2d(0.1, 0.05);
  std::uint32_t rgb = 0x101010;
  bool down_sides = false;
};

/// Faces of a box: the sides by the direction of their outward normal in the box's own axes.
enum class BoxFace : std::uint8_t { kMinusX, kPlusX, kMinusY, kPlusY, kBottom, kTop };

/// A round dent in the top; near an edge it crushes the edge. Its depth falls smoothly from the centre to the rim.
struct BoxDent {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();  ///< in the box's own x and y
  double radius_m = 0.03;
  double depth_m = 0.008;
};

/// A flap of cardboard, hinged at a top edge.
struct BoxFlap {
  BoxFace side = BoxFace::kPlusX;  ///< one of the four sides
  double length_m = 0.08;          ///< from the hinge to the free edge
  /// Of opening: 0 lies on the top, pi / 2 stands, pi is level outwards.
  double angle_rad = 2.356194490192345;
};

/// How the box departs from the cuboid of its nominal size; nothing by default.
struct BoxShape {
  double bulge_m = 0.0;     ///< rise of the top's middle over its edges; below 0 it sags
  double rounding_m = 0.0;  ///< radius of all edges
  std::vector<BoxDent> dents;
  std::vector<BoxFlap> flaps;

  bool isCuboid() const { return bulge_m == 0.0 && rounding_m == 0.0 && dents.empty(); }
};

struct SceneBox {
  std::string name;
  Eigen::Vector3d size_m = Eigen::Vector3d(0.3, 0.2, 0.15);  ///< along its own x, y, z; nominal
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();      ///< of the centre in the floor plane
  double base_z_m = 0.0;                                     ///< height of its underside
  double yaw_rad = 0.0;
  std::uint32_t rgb = 0xb08a5a;
  std::array<std::optional<std::uint32_t>, 6> face_rgb;  ///< by BoxFace, instead of `rgb`
  /// By BoxFace, instead of colours: over the whole face seen from outside, the picture's top towards +z on the
  /// sides and +y on top and bottom.
  std::array<std::shared_ptr<const Texture>, 6> face_texture;
  std::vector<BoxLabel> labels;  ///< a later one covers an earlier one
  BoxShape shape;
};

/// Frame at the centre of the box, along its own axes.
geometry::Pose worldFromBox(const SceneBox& box);

/// Height of the top over its nominal plane [m] at a place of the box's own x and y: bulge and dents, without
/// the rounding of the edges and without flaps.
double topOffset(const SceneBox& box, const Eigen::Vector2d& place_m);

/// The top within its rounded edges, measured from the nominal plane (upwards) [m].
struct TopOffsets {
  double mean_m = 0.0;
  double lowest_m = 0.0;
  double highest_m = 0.0;
};
TopOffsets topOffsets(const SceneBox& box);

/// What the shape has, of "BULGED", "SAGGED", "ROUNDED_EDGES", "DENTED" and "OPEN_FLAPS".
std::vector<std::string> shapeFlags(const BoxShape& shape);

}  // namespace mixed_palletizing::simulation
