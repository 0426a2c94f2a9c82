// Two surfaces of triangles cut each other where an edge of one runs through a triangle of the other; a closed one may
// also lie within the other without an edge through it.
#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "box_mesh.hpp"
#include "drawn_objects.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr double kAllowedDepth = 1e-3;   // [m]: things that stand on each other touch
constexpr double kInsideWinding = 0.75;  // open meshes surround nothing for certain

struct Thing {
  std::string key;
  bool is_box = false;
  TriangleMesh mesh;  // in the world
  Extent extent;
  std::unique_ptr<RayScene> rays;
};

Thing thingOf(const std::string& key, bool is_box, Mesh mesh) {
  Thing thing;
  thing.key = key;
  thing.is_box = is_box;
  thing.rays = std::make_unique<RayScene>(std::vector<Mesh>{mesh});
  thing.mesh.vertices = std::move(mesh.vertices);
  thing.mesh.triangles = std::move(mesh.triangles);
  thing.extent = extentOf(thing.mesh);
  return thing;
}

std::vector<Thing> thingsOf(const Scene& scene) {
  std::vector<Thing> things;
  const auto key = [](const char* list, std::size_t i) { return list + ("[" + std::to_string(i) + "]"); };
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    SceneBox body = scene.boxes[i];
    body.shape.flaps.clear();
    things.push_back(thingOf(key("boxes", i), true, boxMesh(body, worldFromBox(body))));
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    things.push_back(thingOf(key("objects", i), false, objectMesh(object, object.world_from_object)));
  }
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const SceneSurface& surface = scene.surfaces[i];
    things.push_back(thingOf(key("surfaces", i), false, surfaceMesh(surface, surface.world_from_surface)));
  }
  return things;
}

bool apart(const Extent& a, const Extent& b) {
  return ((a.low.array() + kAllowedDepth > b.high.array()) ||
          (b.low.array() + kAllowedDepth > a.high.array()))
      .any();
}

bool edgesPierce(const Thing& a, const Thing& b) {
  for (const auto& triangle : a.mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d& from = a.mesh.vertices[triangle[i]];
      const Eigen::Vector3d& to = a.mesh.vertices[triangle[(i + 1) % 3]];
      if (apart({from.cwiseMin(to), from.cwiseMax(to)}, b.extent)) continue;
      if (b.rays->isPierced(from, to, kAllowedDepth)) return true;
    }
  }
  return false;
}

bool surrounds(const Thing& outer, const Thing& inner) {
  if (apart(outer.extent, inner.extent) || inner.mesh.vertices.empty()) return false;
  return std::abs(windingNumber(outer.mesh, inner.mesh.vertices.front())) > kInsideWinding;
}

bool reachInto(const Thing& a, const Thing& b) {
  if (apart(a.extent, b.extent)) return false;
  return edgesPierce(a, b) || edgesPierce(b, a) || surrounds(a, b) || surrounds(b, a);
}

}  // namespace

std::vector<std::string> warnings(const Scene& scene) {
  std::vector<std::string> lines;
  if (scene.objects.empty() && scene.surfaces.empty()) return lines;
  const std::vector<Thing> things = thingsOf(scene);
  for (std::size_t i = 0; i < things.size(); ++i) {
    const double depth = -things[i].extent.low.z();
    if (!things[i].is_box && depth > kAllowedDepth) {
      std::ostringstream line;
      line << things[i].key << ": reaches " << depth << " m below the floor";
      lines.push_back(line.str());
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (things[i].is_box && things[j].is_box) continue;  // an error, not a warning
      if (reachInto(things[i], things[j])) lines.push_back(things[i].key + ": reaches into " + things[j].key);
    }
  }
  return lines;
}

}  // namespace mixed_palletizing::simulation
