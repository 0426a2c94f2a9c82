// Surfaces on which things stand, and objects of any shape.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/pose.hpp>
#include <mixed_palletizing/simulation/texture.hpp>
#include <mixed_palletizing/simulation/triangle_mesh.hpp>

namespace mixed_palletizing::simulation {

/// A rectangle or flat slab: a table, a conveyor, a deck. Its frame lies in the middle of its upper side, z up.
struct SceneSurface {
  std::string name;  ///< markers and boards name the surface they lie on
  Eigen::Vector2d size_m = Eigen::Vector2d(1.0, 1.0);
  double thickness_m = 0.0;  ///< downwards; 0 is a sheet
  geometry::Pose world_from_surface = geometry::Pose::Identity();
  std::uint32_t rgb = 0x8a8d91;
  std::shared_ptr<const Texture> texture;  ///< over the whole upper side, its picture's top towards +y
};

/// A thing of any shape, placed by rotation and translation.
struct SceneObject {
  std::string name;
  std::string kind = "mesh";  ///< "mesh", "cylinder" or "cuboid", for the truth
  std::shared_ptr<const TriangleMesh> mesh;
  geometry::Pose world_from_object = geometry::Pose::Identity();
  std::uint32_t rgb = 0x3f6f9f;
};

/// Frame of full rotation: roll about x, then pitch about y, then yaw about z, all about fixed axes (REP 103) [rad].
geometry::Pose poseFromRollPitchYaw(const Eigen::Vector3d& position_m, const Eigen::Vector3d& rpy_rad);

}  // namespace mixed_palletizing::simulation
