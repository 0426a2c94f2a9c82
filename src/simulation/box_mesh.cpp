// A curved box is a grid on the faces of its cuboid that is bent in two steps: the edges are rounded by moving every
// point to its place on a ball around the nearest point of a smaller cuboid, then all points are lifted by the
// offset of the top above them, in proportion to their height over the bottom. Faces share the lines of the grid, so
// that the solid stays closed.
#include "box_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mixed_palletizing::simulation {
namespace {

constexpr double kChordError = 1e-5;     // [m] between a curve along an axis and its chord
constexpr double kLeastStep = 2e-4;      // [m] of the grid
constexpr int kArcSteps = 8;             // of half a rounded edge: within 0.024 mm for a radius of 20 mm
constexpr double kFlapThickness = 3e-3;  // [m] of cardboard
constexpr double kPi = 3.14159265358979323846;

void addQuad(Mesh& mesh, const std::array<std::uint32_t, 4>& corners, std::uint8_t face) {
  mesh.triangles.push_back({corners[0], corners[1], corners[2]});
  mesh.triangles.push_back({corners[0], corners[2], corners[3]});
  mesh.faces.insert(mesh.faces.end(), 2, face);
}

/// Longest step whose chord stays within kChordError of a curve of this curvature [1/m].
double stepOf(double curvature) { return std::max(kLeastStep, std::sqrt(8.0 * kChordError / curvature)); }

/// Length of the grid's cell that begins at a place of an axis.
double stepAt(const SceneBox& box, int axis, double place) {
  double step = box.size_m[axis];
  if (axis == 2) return step;
  if (box.shape.bulge_m != 0.0) {
    const double half = 0.5 * box.size_m[axis];
    step = stepOf(2.0 * std::abs(box.shape.bulge_m) / (half * half));
  }
  for (const BoxDent& dent : box.shape.dents) {
    const double fine = stepOf(8.0 * dent.depth_m / (dent.radius_m * dent.radius_m));
    const double begin = dent.center_m[axis] - dent.radius_m;
    if (place < begin - kLeastStep) {
      step = std::min(step, begin - place);
    } else if (place < dent.center_m[axis] + dent.radius_m) {
      step = std::min(step, fine);
    }
  }
  return step;
}

/// Lines of the grid along an axis, from one face to the other; rounded edges have lines at even angles.
std::vector<double> gridLines(const SceneBox& box, int axis) {
  const double half = 0.5 * box.size_m[axis];
  const double radius = box.shape.rounding_m;
  std::vector<double> arc;  // distances from the face
  for (int i = kArcSteps; i >= 0 && radius > 0.0; --i) {
    arc.push_back(radius * (1.0 - std::tan(0.25 * kPi * i / kArcSteps)));
  }
  if (arc.empty()) arc.push_back(0.0);
  arc.front() = 0.0;
  std::vector<double> lines;
  for (const double distance : arc) lines.push_back(-half + distance);
  const double end = half - radius;
  while (lines.back() < end) {
    const double next = lines.back() + stepAt(box, axis, lines.back());
    lines.push_back(next < end - 0.5 * kLeastStep ? next : end);
  }
  for (std::size_t i = arc.size() - 1; i-- > 0;) lines.push_back(half - arc[i]);
  return lines;
}

Eigen::Vector3d bent(const SceneBox& box, const Eigen::Vector3d& point) {
  const double radius = box.shape.rounding_m;
  Eigen::Vector3d place = point;
  if (radius > 0.0) {
    const Eigen::Array3d inner = 0.5 * box.size_m.array() - radius;
    const Eigen::Vector3d center = point.array().min(inner).max(-inner).matrix();
    place = center + radius * (point - center).normalized();
  }
  const double share = place.z() / box.size_m.z() + 0.5;
  place.z() += share * topOffset(box, place.head<2>());
  return place;
}

void addCurvedFace(Mesh& mesh, const SceneBox& box, const std::array<std::vector<double>, 3>& lines,
                   BoxFace face) {
  const int axis = static_cast<int>(face) / 2;
  const bool positive = static_cast<int>(face) % 2 == 1;
  const int u_axis = (axis + 1) % 3;
  const int v_axis = (axis + 2) % 3;
  const std::vector<double>& us = lines[static_cast<std::size_t>(u_axis)];
  const std::vector<double>& vs = lines[static_cast<std::size_t>(v_axis)];
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  Eigen::Vector3d point;
  point[axis] = positive ? 0.5 * box.size_m[axis] : -0.5 * box.size_m[axis];
  for (const double v : vs) {
    for (const double u : us) {
      point[u_axis] = u;
      point[v_axis] = v;
      mesh.vertices.push_back(bent(box, point));
    }
  }
  const auto width = static_cast<std::uint32_t>(us.size());
  for (std::uint32_t row = 0; row + 1 < vs.size(); ++row) {
    for (std::uint32_t col = 0; col + 1 < width; ++col) {
      const std::uint32_t a = first + row * width + col;
      const std::array<std::uint32_t, 4> outwards = {a, a + 1, a + width + 1, a + width};
      const std::array<std::uint32_t, 4> turned = {a, a + width, a + width + 1, a + 1};
      addQuad(mesh, positive ? outwards : turned, static_cast<std::uint8_t>(face));
    }
  }
}

void addFlatFace(Mesh& mesh, const std::array<Eigen::Vector3d, 4>& corners, std::uint8_t face) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  addQuad(mesh, {first, first + 1, first + 2, first + 3}, face);
}

/// A thin slab hinged at its side's top edge; it lies outside the cuboid at every angle.
void addFlap(Mesh& mesh, const SceneBox& box, const BoxFlap& flap) {
  const int axis = static_cast<int>(flap.side) / 2;
  const double sign = static_cast<int>(flap.side) % 2 == 0 ? -1.0 : 1.0;
  const Eigen::Vector3d outwards = sign * Eigen::Vector3d::Unit(axis);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const double half_width = 0.5 * box.size_m[1 - axis] - box.shape.rounding_m;
  const Eigen::Vector3d along = up.cross(outwards) * half_width;
  const double c = std::cos(flap.angle_rad);
  const double s = std::sin(flap.angle_rad);
  const double beside =
      0.5 * box.size_m[axis] + kFlapThickness * std::max(0.0, -s);  // hanging: clear of the side
  const Eigen::Vector3d hinge = beside * outwards + 0.5 * box.size_m.z() * up;
  const Eigen::Vector3d reach = flap.length_m * (s * up - c * outwards);
  const Eigen::Vector3d thickness = kFlapThickness * (c * up + s * outwards);
  std::array<Eigen::Vector3d, 8> p;
  for (std::size_t i = 0; i < 8; ++i) {
    p[i] = hinge + ((i & 1) != 0 ? reach : Eigen::Vector3d::Zero()) +
           ((i & 2) != 0 ? along : Eigen::Vector3d(-along)) +
           ((i & 4) != 0 ? thickness : Eigen::Vector3d::Zero());
  }
  constexpr std::array<std::array<std::size_t, 4>, 6> kSides = {
      {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};
  for (const auto& side : kSides) {
    addFlatFace(mesh, {p[side[0]], p[side[1]], p[side[2]], p[side[3]]}, kFlapFace);
  }
}

}  // namespace

std::array<Eigen::Vector3d, 4> faceCorners(const SceneBox& box, BoxFace face) {
  const int axis = static_cast<int>(face) / 2;
  const double sign = static_cast<int>(face) % 2 == 0 ? -1.0 : 1.0;
  const Eigen::Vector3d half = 0.5 * box.size_m;
  const Eigen::Vector3d middle = sign * half[axis] * Eigen::Vector3d::Unit(axis);
  const Eigen::Vector3d u = half[(axis + 1) % 3] * Eigen::Vector3d::Unit((axis + 1) % 3);
  const Eigen::Vector3d v = sign * half[(axis + 2) % 3] * Eigen::Vector3d::Unit((axis + 2) % 3);
  return {middle - u - v, middle + u - v, middle + u + v, middle - u + v};
}

Mesh boxMesh(const SceneBox& box, const geometry::Pose& camera_from_box) {
  Mesh mesh;
  std::array<std::vector<double>, 3> lines;
  if (!box.shape.isCuboid()) {
    for (int axis = 0; axis < 3; ++axis) lines[static_cast<std::size_t>(axis)] = gridLines(box, axis);
  }
  for (std::uint8_t face = 0; face < 6; ++face) {
    if (box.shape.isCuboid()) {
      addFlatFace(mesh, faceCorners(box, static_cast<BoxFace>(face)), face);
    } else {
      addCurvedFace(mesh, box, lines, static_cast<BoxFace>(face));
    }
  }
  for (const BoxFlap& flap : box.shape.flaps) addFlap(mesh, box, flap);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = camera_from_box * vertex;
  return mesh;
}

}  // namespace mixed_palletizing::simulation
