#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/adapters/cell/simulator_layout.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>

namespace mixed_palletizing::cell {
namespace {

/// The shadow of a box is judged at this many heights between a target and its own top.
constexpr int kShadowSlices = 6;
/// A shadow ends this far before what must be seen [m].
constexpr double kShadowMargin = 0.005;

geometry::Rectangle footprint(const simulation::SceneBox& box) {
  return {box.position_m, box.yaw_rad, box.size_m.head<2>()};
}

double topOf(const simulation::SceneBox& box) { return box.base_z_m + box.size_m.z(); }

void throwProblems(const CellLayoutOptions& options) {
  std::string text;
  for (const std::string& problem : problems(options)) text += (text.empty() ? "" : "; ") + problem;
  if (!text.empty()) throw std::invalid_argument("CellLayout: options: " + text);
}

}  // namespace

std::vector<std::string> problems(const CellLayoutOptions& options) {
  std::vector<std::string> all;
  const auto require = [&](bool holds, const std::string& key, double value, const std::string& what) {
    if (!holds) all.push_back(key + ": " + std::to_string(value) + " " + what);
  };
  require(options.gap_m > 0.0 && options.gap_m <= 10.0, "gap_m", options.gap_m, "is not in (0, 10] m");
  require(options.border_px >= 0.0 && options.border_px <= 1e5, "border_px", options.border_px,
          "is not in [0, 100000]");
  require(options.tries >= 1 && options.tries <= 1000000, "tries", options.tries, "is not in [1, 1000000]");
  return all;
}

CellLayout::CellLayout(const simulation::Scene& scene, const CellLayoutOptions& options)
    : options_(options), camera_(scene.camera) {
  throwProblems(options);
  const double right = camera_.width_px - 1;
  const double bottom = camera_.height_px - 1;
  view_min_ = view_max_ = onFloor(0.0, 0.0);
  for (const Eigen::Vector2d& corner : {onFloor(right, 0.0), onFloor(0.0, bottom), onFloor(right, bottom)}) {
    view_min_ = view_min_.cwiseMin(corner);
    view_max_ = view_max_.cwiseMax(corner);
  }
  if (!scene.has_marker) return;
  const double side = scene.marker.side_m + 2.0 * scene.marker.quiet_zone_m;
  paper_ = geometry::Rectangle{scene.marker.position_m, scene.marker.yaw_rad, {side, side}};
  for (const Eigen::Vector2d& corner : paper_->corners()) {
    if (inImage(Eigen::Vector3d(corner.x(), corner.y(), 0.0))) continue;
    throw std::invalid_argument("CellLayout: the marker is not wholly in the camera's image");
  }
}

/// Where the ray through (u, v) meets the floor.
Eigen::Vector2d CellLayout::onFloor(double u, double v) const {
  const Eigen::Vector3d eye = camera_.world_from_camera.translation();
  const Eigen::Vector3d ray = camera_.world_from_camera.linear() * simulation::Pinhole(camera_).ray(u, v);
  if (!(ray.normalized().z() < -0.05)) {
    throw std::invalid_argument("CellLayout: the camera's image reaches the horizon: less tilt is needed");
  }
  return (eye - eye.z() / ray.z() * ray).head<2>();
}

bool CellLayout::inImage(const Eigen::Vector3d& point_world) const {
  const Eigen::Vector3d point = camera_.world_from_camera.inverse() * point_world;
  if (!(point.z() > 0.0)) return false;
  const Eigen::Vector2d uv = simulation::Pinhole(camera_).project(point);
  const double border = options_.border_px;
  return uv.x() >= border && uv.y() >= border && uv.x() <= camera_.width_px - 1 - border &&
         uv.y() <= camera_.height_px - 1 - border;
}

bool CellLayout::inImage(const simulation::SceneBox& box) const {
  for (const Eigen::Vector2d& corner : footprint(box).corners()) {
    if (!inImage({corner.x(), corner.y(), box.base_z_m})) return false;
    if (!inImage({corner.x(), corner.y(), topOf(box)})) return false;
  }
  return true;
}

/// Seen from the camera, a level slice of the blocker at height z covers, in the plane of the target, the slice
/// scaled about the point below the camera.
bool CellLayout::hides(const simulation::SceneBox& blocker, const geometry::Rectangle& target,
                       double target_z) const {
  const Eigen::Vector3d eye = camera_.world_from_camera.translation();
  const double rise = topOf(blocker) - target_z;
  if (rise <= 0.0) return false;
  for (int i = 0; i < kShadowSlices; ++i) {
    const double z = target_z + rise * i / (kShadowSlices - 1);
    if (z >= eye.z()) return true;
    const double scale = (eye.z() - target_z) / (eye.z() - z);
    geometry::Rectangle shadow = footprint(blocker);
    shadow.center = eye.head<2>() + scale * (shadow.center - eye.head<2>());
    shadow.size *= scale;
    if (geometry::distance(shadow, target) < kShadowMargin) return true;
  }
  return false;
}

bool CellLayout::allows(const simulation::SceneBox& box,
                        const std::vector<simulation::SceneBox>& others) const {
  if (!inImage(box)) return false;
  const geometry::Rectangle own = footprint(box);
  if (paper_ && (geometry::distance(own, *paper_) < options_.gap_m || hides(box, *paper_, 0.0))) return false;
  return std::all_of(others.begin(), others.end(), [&](const simulation::SceneBox& other) {
    const geometry::Rectangle its = footprint(other);
    return geometry::distance(own, its) >= options_.gap_m && !hides(box, its, topOf(other)) &&
           !hides(other, own, topOf(box));
  });
}

bool CellLayout::place(simulation::SceneBox& box, const std::vector<simulation::SceneBox>& others,
                       std::mt19937_64& random) const {
  simulation::SceneBox placed = box;
  std::uniform_real_distribution<double> x(view_min_.x(), view_max_.x());
  std::uniform_real_distribution<double> y(view_min_.y(), view_max_.y());
  std::uniform_real_distribution<double> yaw(-M_PI_2, M_PI_2);
  for (int i = 0; i < options_.tries; ++i) {
    placed.position_m.x() = x(random);
    placed.position_m.y() = y(random);
    placed.yaw_rad = yaw(random);
    if (!allows(placed, others)) continue;
    box = placed;
    return true;
  }
  return false;
}

}  // namespace mixed_palletizing::cell
