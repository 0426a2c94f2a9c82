#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <mixed_palletizing/simulation/triangle_mesh.hpp>

namespace mixed_palletizing::simulation {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kChordError = 2e-5;  // [m] between a circle and its polygon
constexpr int kMaxSegments = 720;

int segmentsOf(double radius) {
  const double half_angle = std::acos(std::max(0.0, 1.0 - kChordError / radius));
  return std::clamp(static_cast<int>(std::ceil(kPi / half_angle)), 16, kMaxSegments);
}

}  // namespace

Extent extentOf(const TriangleMesh& mesh) {
  Extent extent;
  if (mesh.vertices.empty()) return extent;
  extent.low = extent.high = mesh.vertices.front();
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    extent.low = extent.low.cwiseMin(vertex);
    extent.high = extent.high.cwiseMax(vertex);
  }
  return extent;
}

TriangleMesh cylinderMesh(double radius_m, double height_m) {
  const auto segments = static_cast<std::uint32_t>(segmentsOf(radius_m));
  TriangleMesh mesh;
  mesh.vertices = {{0.0, 0.0, 0.0}, {0.0, 0.0, height_m}};
  for (std::uint32_t i = 0; i < segments; ++i) {
    const double angle = 2.0 * kPi * i / segments;
    const Eigen::Vector3d low(radius_m * std::cos(angle), radius_m * std::sin(angle), 0.0);
    mesh.vertices.push_back(low);
    mesh.vertices.push_back(low + Eigen::Vector3d(0.0, 0.0, height_m));
    const std::uint32_t here = 2 + 2 * i;
    const std::uint32_t next = 2 + 2 * ((i + 1) % segments);
    mesh.triangles.push_back({here, next, next + 1});
    mesh.triangles.push_back({here, next + 1, here + 1});
    mesh.triangles.push_back({0, next, here});
    mesh.triangles.push_back({1, here + 1, next + 1});
  }
  return mesh;
}

TriangleMesh cuboidMesh(const Eigen::Vector3d& size_m) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices.emplace_back((corner & 1 ? 0.5 : -0.5) * size_m.x(), (corner & 2 ? 0.5 : -0.5) * size_m.y(),
                               corner & 4 ? size_m.z() : 0.0);
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& side : kSides) {
    mesh.triangles.push_back({side[0], side[1], side[2]});
    mesh.triangles.push_back({side[0], side[2], side[3]});
  }
  return mesh;
}

double windingNumber(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  double solid_angle = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[triangle[0]] - point;
    const Eigen::Vector3d b = mesh.vertices[triangle[1]] - point;
    const Eigen::Vector3d c = mesh.vertices[triangle[2]] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    const double volume = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    solid_angle += 2.0 * std::atan2(volume, denominator);
  }
  return solid_angle / (4.0 * kPi);
}

}  // namespace mixed_palletizing::simulation
