// What a camera sees of boxes, judged without casting an image.
#pragma once

#include <optional>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/rectangle.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

#include "draws.hpp"

namespace mixed_palletizing::simulation {

geometry::Rectangle footprint(const SceneBox& box);

/// The marker with its quiet zone.
geometry::Rectangle paper(const Marker& marker);

/// The image less its border, as seen from the world.
class SceneView {
 public:
  SceneView(const Camera& camera, double border_ratio);

  bool contains(const Eigen::Vector3d& world_point) const;
  bool contains(const SceneBox& box) const;
  bool contains(const geometry::Rectangle& on_floor) const;

  /// Place on the floor that a random pixel sees, of the image grown by `beyond_ratio` of its sides; nothing
  /// above the horizon.
  std::optional<Eigen::Vector2d> floorPlace(Draws& draws, double beyond_ratio = 0.0) const;

 private:
  Camera camera_;
  Pinhole pinhole_;
  double border_px_;
  geometry::Pose camera_from_world_;
};

/// Share of the top of scene.boxes[index] that lies in the image and that neither the camera nor the projector
/// is kept from by another box, by a grid of points. Cuboids only: what their tops are like does not count.
double topVisibility(const Scene& scene, const SceneView& image, std::size_t index);

/// Whether no box stands between the marker's paper and the camera or the projector.
bool markerInSight(const Scene& scene);

}  // namespace mixed_palletizing::simulation
