#include "drawn_objects.hpp"

#include <cmath>
#include <utility>

#include "box_mesh.hpp"

namespace mixed_palletizing::simulation {

using geometry::Pose;

SceneSurface floorSurface(const Floor& floor) {
  SceneSurface surface;
  surface.size_m = {floor.size_x_m, floor.size_y_m};
  surface.rgb = floor.rgb;
  surface.texture = floor.texture;
  return surface;
}

Mesh objectMesh(const SceneObject& object, const Pose& camera_from_object) {
  Mesh mesh;
  mesh.vertices.reserve(object.mesh->vertices.size());
  for (const Eigen::Vector3d& vertex : object.mesh->vertices) {
    mesh.vertices.push_back(camera_from_object * vertex);
  }
  mesh.triangles = object.mesh->triangles;
  mesh.faces.assign(mesh.triangles.size(), 0);
  return mesh;
}

Mesh surfaceMesh(const SceneSurface& surface, const Pose& camera_from_surface) {
  SceneBox slab;
  slab.size_m = {surface.size_m.x(), surface.size_m.y(), surface.thickness_m};
  Mesh mesh;
  const auto add = [&](BoxFace face, std::uint8_t name) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector3d& corner : faceCorners(slab, face)) {
      mesh.vertices.push_back(camera_from_surface *
                              (corner - Eigen::Vector3d(0.0, 0.0, 0.5 * surface.thickness_m)));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
    mesh.faces.insert(mesh.faces.end(), 2, name);
  };
  add(BoxFace::kTop, 0);
  if (surface.thickness_m == 0.0) return mesh;
  for (const BoxFace face :
       {BoxFace::kMinusX, BoxFace::kPlusX, BoxFace::kMinusY, BoxFace::kPlusY, BoxFace::kBottom}) {
    add(face, 1);
  }
  return mesh;
}

DrawnObjects drawnObjects(const Scene& scene) {
  const Pose camera_from_world = scene.camera.world_from_camera.inverse();
  DrawnObjects drawn;
  const auto add = [&](Mesh mesh, std::unique_ptr<Paint> paint) {
    drawn.meshes.push_back(std::move(mesh));
    drawn.paints.push_back(std::move(paint));
  };
  const SceneSurface floor = floorSurface(scene.floor);
  add(surfaceMesh(floor, camera_from_world), surfacePaint(scene, floor));
  for (const SceneBox& box : scene.boxes) {
    const Pose camera_from_box = camera_from_world * worldFromBox(box);
    add(boxMesh(box, camera_from_box), boxPaint(box, camera_from_box));
  }
  for (const SceneObject& object : scene.objects) {
    add(objectMesh(object, camera_from_world * object.world_from_object), plainPaint(object.rgb));
  }
  for (const SceneSurface& surface : scene.surfaces) {
    add(surfaceMesh(surface, camera_from_world * surface.world_from_surface), surfacePaint(scene, surface));
  }
  return drawn;
}

std::vector<Eigen::Vector3d> topCorners(const SceneBox& box, const Pose& camera_from_world) {
  const Pose camera_from_box = camera_from_world * worldFromBox(box);
  std::vector<Eigen::Vector3d> corners;
  // The outer half of a rounded edge is more a side than the top.
  const Eigen::Array2d inset = Eigen::Array2d::Constant((1.0 - std::sqrt(0.5)) * box.shape.rounding_m);
  const Eigen::Array2d share = 1.0 - 2.0 * inset / box.size_m.head<2>().array();
  for (Eigen::Vector3d corner : faceCorners(box, BoxFace::kTop)) {
    corner.head<2>().array() *= share;
    corners.push_back(camera_from_box * corner);
  }
  return corners;
}

}  // namespace mixed_palletizing::simulation
