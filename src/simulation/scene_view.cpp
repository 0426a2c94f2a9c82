#include "scene_view.hpp"

#include <algorithm>
#include <vector>

namespace mixed_palletizing::simulation {
namespace {

using geometry::Pose;

constexpr int kTopSteps = 20;    // of the grid along each side of a top
constexpr int kPaperSteps = 6;   // likewise of the marker's paper
constexpr double kInset = 1e-3;  // [m] of the grid from the edge: a top's own edge hides nothing

/// A box as its own axes see it.
struct Solid {
  explicit Solid(const SceneBox& box)
      : box_from_world(worldFromBox(box).inverse()), half(0.5 * box.size_m.array()) {}

  /// Whether it stands between two points (slab test).
  bool blocks(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const Eigen::Array3d start = (box_from_world * from).array();
    const Eigen::Array3d path = (box_from_world * to).array() - start;
    const Eigen::Array3d one = (-half - start) / path;  // infinite along a face: the comparisons stand it
    const Eigen::Array3d two = (half - start) / path;
    return std::max(one.min(two).maxCoeff(), 0.0) < std::min(one.max(two).minCoeff(), 1.0);
  }

  Pose box_from_world;
  Eigen::Array3d half;
};

/// The camera's place and, if there is one, the projector's.
std::vector<Eigen::Vector3d> eyes(const Camera& camera) {
  std::vector<Eigen::Vector3d> places{camera.world_from_camera.translation()};
  if (camera.projector_m) places.push_back(camera.world_from_camera * *camera.projector_m);
  return places;
}

bool reached(const Eigen::Vector3d& point, const std::vector<Eigen::Vector3d>& eyes,
             const std::vector<Solid>& solids) {
  for (const Eigen::Vector3d& eye : eyes) {
    for (const Solid& solid : solids) {
      if (solid.blocks(eye, point)) return false;
    }
  }
  return true;
}

/// Calls visit(x, y) for a grid over a rectangle of these sides around the origin, its edges included.
template <typename Visit>
void forGrid(const Eigen::Vector2d& size, int steps, const Visit& visit) {
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      visit((static_cast<double>(i) / steps - 0.5) * size.x(),
            (static_cast<double>(j) / steps - 0.5) * size.y());
    }
  }
}

}  // namespace

geometry::Rectangle footprint(const SceneBox& box) {
  return {box.position_m, box.yaw_rad, box.size_m.head<2>()};
}

geometry::Rectangle paper(const Marker& marker) {
  return {marker.position_m, marker.yaw_rad,
          Eigen::Vector2d::Constant(marker.side_m + 2.0 * marker.quiet_zone_m)};
}

SceneView::SceneView(const Camera& camera, double border_ratio)
    : camera_(camera),
      pinhole_(camera),
      border_px_(border_ratio * camera.width_px),
      camera_from_world_(camera.world_from_camera.inverse()) {}

bool SceneView::contains(const Eigen::Vector3d& world_point) const {
  const Eigen::Vector3d point = camera_from_world_ * world_point;
  if (!(point.z() > 0.0)) return false;
  const Eigen::Vector2d image = pinhole_.project(point);
  return (image.array() >= border_px_).all() && image.x() <= camera_.width_px - 1 - border_px_ &&
         image.y() <= camera_.height_px - 1 - border_px_;
}

bool SceneView::contains(const SceneBox& box) const {
  const Pose world_from_box = worldFromBox(box);
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Array3d signs(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    if (!contains(world_from_box * Eigen::Vector3d(signs * box.size_m.array()))) return false;
  }
  return true;
}

bool SceneView::contains(const geometry::Rectangle& on_floor) const {
  for (const Eigen::Vector2d& corner : on_floor.corners()) {
    if (!contains(Eigen::Vector3d(corner.x(), corner.y(), 0.0))) return false;
  }
  return true;
}

std::optional<Eigen::Vector2d> SceneView::floorPlace(Draws& draws, double beyond_ratio) const {
  const double u = draws.between(-beyond_ratio, 1.0 + beyond_ratio) * camera_.width_px;
  const double v = draws.between(-beyond_ratio, 1.0 + beyond_ratio) * camera_.height_px;
  const Eigen::Vector3d ray = camera_.world_from_camera.linear() * pinhole_.ray(u, v);
  const Eigen::Vector3d eye = camera_.world_from_camera.translation();
  if (!(ray.z() < -1e-6)) return std::nullopt;
  return Eigen::Vector2d((eye - ray * (eye.z() / ray.z())).head<2>());
}

double topVisibility(const Scene& scene, const SceneView& image, std::size_t index) {
  std::vector<Solid> others;
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    if (i != index) others.emplace_back(scene.boxes[i]);
  }
  const SceneBox& box = scene.boxes[index];
  const Pose world_from_box = worldFromBox(box);
  const std::vector<Eigen::Vector3d> places = eyes(scene.camera);
  const Eigen::Vector2d size = (box.size_m.head<2>().array() - 2.0 * kInset).max(0.0);
  int seen = 0;
  forGrid(size, kTopSteps, [&](double x, double y) {
    const Eigen::Vector3d point = world_from_box * Eigen::Vector3d(x, y, 0.5 * box.size_m.z());
    if (image.contains(point) && reached(point, places, others)) ++seen;
  });
  return static_cast<double>(seen) / ((kTopSteps + 1) * (kTopSteps + 1));
}

bool markerInSight(const Scene& scene) {
  const std::vector<Solid> solids(scene.boxes.begin(), scene.boxes.end());
  const std::vector<Eigen::Vector3d> places = eyes(scene.camera);
  const geometry::Rectangle rectangle = paper(scene.marker);
  bool all = true;
  forGrid(rectangle.size, kPaperSteps, [&](double x, double y) {
    const Eigen::Vector2d point = rectangle.center + rectangle.axisX() * x + rectangle.axisY() * y;
    all = all && reached({point.x(), point.y(), 0.0}, places, solids);
  });
  return all;
}

}  // namespace mixed_palletizing::simulation
