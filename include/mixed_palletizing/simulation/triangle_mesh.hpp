// Closed or open surfaces of triangles: CAD and mesh files, and the simple solids.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mixed_palletizing::simulation {

/// Triangles in metres, corners counter-clockwise seen from outside (both sides can be seen).
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct Extent {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
};

/// Bounding box; zeros for a mesh without vertices.
Extent extentOf(const TriangleMesh& mesh);

/// Cylinder and cuboid: the origin in the middle of the underside, z up. Round parts are within 0.02 mm.
TriangleMesh cylinderMesh(double radius_m, double height_m);
TriangleMesh cuboidMesh(const Eigen::Vector3d& size_m);

/// How often the surface surrounds the point (solid angle over 4 pi): 1 within a closed mesh, 0 outside.
/// O(triangles). Source: Van Oosterom, Strackee, The solid angle of a plane triangle, 1983.
double windingNumber(const TriangleMesh& mesh, const Eigen::Vector3d& point);

constexpr std::size_t kMaxMeshTriangles = 2000000;
constexpr double kMaxMeshExtent = 20.0;   ///< [m]
constexpr double kMinMeshExtent = 0.001;  ///< [m]

/// Reads STL, PLY, OBJ, DAE and whatever else Assimp reads; `metres_per_unit` multiplies its numbers (a DAE file's
/// own unit is applied before). With `recenter` the middle of the bounding box's underside becomes the origin.
/// Throws std::runtime_error "PATH: reason" when the file cannot be read or has no triangles, more than
/// kMaxMeshTriangles, coordinates that are no finite numbers, or an extent outside [kMinMeshExtent, kMaxMeshExtent].
std::shared_ptr<const TriangleMesh> loadMesh(const std::string& path, double metres_per_unit = 1.0,
                                             bool recenter = false);

}  // namespace mixed_palletizing::simulation
