#include "rules.hpp"

namespace mixed_palletizing::simulation {

void checkSurface(const SceneSurface& surface, const std::string& key, Rules& rules) {
  rules.lengths(key + ".size_m", surface.size_m);
  rules.require(surface.thickness_m >= 0.0 && surface.thickness_m <= kMaxLength, key + ".thickness_m",
                surface.thickness_m, "is not in [0, 100] m");
  rules.pose(key + ".pose", surface.world_from_surface);
  rules.color(key + ".rgb", surface.rgb);
}

void checkObject(const SceneObject& object, const std::string& key, Rules& rules) {
  rules.pose(key + ".pose", object.world_from_object);
  rules.color(key + ".rgb", object.rgb);
  if (!object.mesh || object.mesh->triangles.empty()) {
    rules.add(key + ".mesh", "has no triangles");
    return;
  }
  for (const Eigen::Vector3d& vertex : object.mesh->vertices) {
    if ((vertex.array().abs() <= kMaxLength).all()) continue;
    rules.place(key + ".mesh", vertex);
    return;
  }
  for (const auto& triangle : object.mesh->triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner < object.mesh->vertices.size()) continue;
      rules.add(key + ".mesh", "a triangle has a corner that there is not");
      return;
    }
  }
}

}  // namespace mixed_palletizing::simulation
