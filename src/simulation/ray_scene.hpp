// Triangles seen from the camera: Embree finds which one a ray meets, its plane then gives the exact depth.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

namespace mixed_palletizing::simulation {

/// Triangles of one object in the camera's optical frame [m]; corners counter-clockwise seen from outside.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint8_t> faces;  ///< of every triangle: what the object's surface calls it
};

struct RayHit {
  int object = -1;  ///< index of the mesh; -1 when the ray meets nothing
  std::uint8_t face = 0;
  double depth_m = 0.0;  ///< z of the point
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

class RayScene {
 public:
  /// Throws std::runtime_error when Embree cannot be set up.
  explicit RayScene(const std::vector<Mesh>& objects);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// First triangle on the ray from the camera along `direction` (z = 1). Safe from several threads.
  RayHit trace(const Eigen::Vector3d& direction) const;

  /// Whether something stands between a point of a surface and another point [m].
  bool isBlocked(const Eigen::Vector3d& surface_point, const Eigen::Vector3d& other) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mixed_palletizing::simulation
