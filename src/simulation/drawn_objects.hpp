// The things of a scene as the ray caster needs them: triangles and paint.
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/simulation/scene.hpp>

#include "paints.hpp"
#include "ray_scene.hpp"

namespace mixed_palletizing::simulation {

struct DrawnObjects {
  std::vector<Mesh> meshes;
  std::vector<std::unique_ptr<Paint>> paints;  ///< one for every mesh
};

/// In the camera's frame: number 0 is the floor, i + 1 is scene.boxes[i], then come scene.objects, then
/// scene.surfaces.
DrawnObjects drawnObjects(const Scene& scene);

/// The floor as a surface; it has no name.
SceneSurface floorSurface(const Floor& floor);

/// Triangles of an object, and of a surface: a sheet of two or a slab of twelve, the upper side is face 0.
Mesh objectMesh(const SceneObject& object, const geometry::Pose& camera_from_object);
Mesh surfaceMesh(const SceneSurface& surface, const geometry::Pose& camera_from_surface);

/// Corners of a box's top in the optical frame [m], in order around it: of the nominal plane, less the half of
/// the rounded edges that belongs to the sides.
std::vector<Eigen::Vector3d> topCorners(const SceneBox& box, const geometry::Pose& camera_from_world);

}  // namespace mixed_palletizing::simulation
