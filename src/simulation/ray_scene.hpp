// Triangles seen from the camera: Embree finds which one a ray meets, its plane then gives the exact depth.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

namespace mixed_palletizing::simulation {

/// Triangles of one object in the camera's optical frame [m].
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint8_t> faces;  ///< of every triangle: what the object's surface calls it
};

struct RayHit {
  int object = -1;  ///< index of the mesh; -1 when the ray meets nothing
  std::uint8_t face = 0;
  double depth_m = 0.0;                               ///< z of the point
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the side that the ray comes from
};

/// Neighbouring rays are cast together, which is faster than one by one.
constexpr int kPacketSize = 8;
using RayDirections = std::array<Eigen::Vector3d, kPacketSize>;
using RayHits = std::array<RayHit, kPacketSize>;
using RayFlags = std::array<bool, kPacketSize>;

class RayScene {
 public:
  /// Throws std::runtime_error when Embree cannot be set up.
  explicit RayScene(const std::vector<Mesh>& objects);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// First triangles on the rays from the camera along the directions (z = 1). Safe from several threads.
  RayHits trace(const RayDirections& directions) const;

  /// Whether something stands between points of surfaces and another point [m]; of those with `asked` only.
  RayFlags areBlocked(const RayDirections& surface_points, const RayFlags& asked,
                      const Eigen::Vector3d& other) const;

  /// Whether the segment between two points runs through a triangle whose plane both of them are farther from
  /// than `margin` [m]: one that only touches does not.
  bool isPierced(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double margin) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mixed_palletizing::simulation
