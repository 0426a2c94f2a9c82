#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <mixed_palletizing/geometry/rectangle.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>
#include <mixed_palletizing/simulation/random_scene.hpp>

#include "counter_random.hpp"

namespace mixed_palletizing::simulation {
namespace {

using geometry::Pose;

constexpr double kPi = 3.14159265358979323846;
constexpr int kSceneAttempts = 300;
constexpr int kBoxAttempts = 60;
constexpr int kPreviewWidth = 480;  // [px] of the image that visibility is judged in
constexpr std::array<std::uint32_t, 6> kCartonColors = {0xb08a5a, 0xc19a6b, 0x9c7a4d,
                                                        0xa9825a, 0xd0c8b8, 0x8d6b3f};

/// Draws in sequence.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) { return low + (high - low) * random_.uniform(count_++, 0); }
  int integer(int low, int high) {
    return low + static_cast<int>(std::floor(between(0.0, static_cast<double>(high - low + 1))));
  }

 private:
  CounterRandom random_;
  std::uint64_t count_ = 0;
};

/// The image less its border, as seen from the world.
class View {
 public:
  View(const Camera& camera, double border_ratio)
      : camera_(camera),
        pinhole_(camera),
        border_px_(border_ratio * camera.width_px),
        camera_from_world_(camera.world_from_camera.inverse()) {}

  bool contains(const Eigen::Vector3d& world_point) const {
    const Eigen::Vector3d point = camera_from_world_ * world_point;
    if (!(point.z() > 0.0)) return false;
    const Eigen::Vector2d image = pinhole_.project(point);
    return (image.array() >= border_px_).all() && image.x() <= camera_.width_px - 1 - border_px_ &&
           image.y() <= camera_.height_px - 1 - border_px_;
  }

  bool contains(const SceneBox& box) const {
    const Pose world_from_box = worldFromBox(box);
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Array3d signs(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      if (!contains(world_from_box * Eigen::Vector3d(signs * box.size_m.array()))) return false;
    }
    return true;
  }

  /// Place on the floor that a random pixel sees; nothing above the horizon.
  std::optional<Eigen::Vector2d> floorPlace(Draws& draws) const {
    const double u = draws.between(0.0, camera_.width_px);
    const double v = draws.between(0.0, camera_.height_px);
    const Eigen::Vector3d ray = camera_.world_from_camera.linear() * pinhole_.ray(u, v);
    const Eigen::Vector3d eye = camera_.world_from_camera.translation();
    if (!(ray.z() < -1e-6)) return std::nullopt;
    return Eigen::Vector2d((eye - ray * (eye.z() / ray.z())).head<2>());
  }

 private:
  const Camera& camera_;
  Pinhole pinhole_;
  double border_px_;
  Pose camera_from_world_;
};

geometry::Rectangle footprint(const SceneBox& box) {
  return {box.position_m, box.yaw_rad, box.size_m.head<2>()};
}

geometry::Rectangle paper(const Marker& marker) {
  return {marker.position_m, marker.yaw_rad,
          Eigen::Vector2d::Constant(marker.side_m + 2.0 * marker.quiet_zone_m)};
}

/// Whether the box stands between two points (slab test in the box's axes).
bool blocks(const SceneBox& box, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Pose box_from_world = worldFromBox(box).inverse();
  const Eigen::Array3d start = (box_from_world * from).array();
  const Eigen::Array3d path = (box_from_world * to).array() - start;
  const Eigen::Array3d half = 0.5 * box.size_m.array();
  const Eigen::Array3d one = (-half - start) / path;  // infinite along a face: the comparisons below stand it
  const Eigen::Array3d two = (half - start) / path;
  return std::max(one.min(two).maxCoeff(), 0.0) < std::min(one.max(two).minCoeff(), 1.0);
}

bool markerInSight(const Scene& scene, const SceneBox& box) {
  constexpr int kSteps = 6;
  const geometry::Rectangle rectangle = paper(scene.marker);
  const Eigen::Vector3d eye = scene.camera.world_from_camera.translation();
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Eigen::Vector2d share(static_cast<double>(i) / kSteps - 0.5,
                                  static_cast<double>(j) / kSteps - 0.5);
      const Eigen::Vector2d point = rectangle.center + rectangle.axisX() * (share.x() * rectangle.size.x()) +
                                    rectangle.axisY() * (share.y() * rectangle.size.y());
      if (blocks(box, eye, {point.x(), point.y(), 0.0})) return false;
    }
  }
  return true;
}

bool drawCamera(const RandomSceneOptions& options, Draws& draws, Scene& scene) {
  const double distance = draws.between(options.distance_min_m, options.distance_max_m);
  const double tilt = draws.between(options.tilt_min_rad, options.tilt_max_rad);
  const double azimuth = draws.between(-kPi, kPi);
  const double offset = options.target_offset_max_m * std::sqrt(draws.between(0.0, 1.0));
  const double bearing = draws.between(-kPi, kPi);
  const Eigen::Vector2d middle = scene.has_marker ? scene.marker.position_m : Eigen::Vector2d(0.0, 0.0);
  const Eigen::Vector3d target(middle.x() + offset * std::cos(bearing),
                               middle.y() + offset * std::sin(bearing), 0.0);
  const Eigen::Vector3d direction(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                                  std::cos(tilt));
  scene.camera.world_from_camera = lookAt(target + distance * direction, target);
  if (!scene.has_marker) return true;
  const View view(scene.camera, options.border_px_ratio);
  for (const Eigen::Vector2d& corner : paper(scene.marker).corners()) {
    if (!view.contains(Eigen::Vector3d(corner.x(), corner.y(), 0.0))) return false;
  }
  return true;
}

bool fits(const RandomSceneOptions& options, const View& view, const Scene& scene, const SceneBox& box) {
  if (!view.contains(box)) return false;
  for (const SceneBox& other : scene.boxes) {
    if (geometry::distance(footprint(box), footprint(other)) < options.gap_m) return false;
  }
  if (!scene.has_marker) return true;
  if (geometry::distance(footprint(box), paper(scene.marker)) < options.gap_m) return false;
  return !options.marker_in_sight || markerInSight(scene, box);
}

bool drawBox(const RandomSceneOptions& options, const View& view, Draws& draws, Scene& scene) {
  for (int attempt = 0; attempt < kBoxAttempts; ++attempt) {
    SceneBox box;
    for (int axis = 0; axis < 3; ++axis) {
      box.size_m[axis] = draws.between(options.box_size_min_m[axis], options.box_size_max_m[axis]);
    }
    box.yaw_rad = draws.between(-0.5 * kPi, 0.5 * kPi);
    box.rgb = kCartonColors[static_cast<std::size_t>(draws.integer(0, kCartonColors.size() - 1))];
    box.name = "box_" + std::to_string(scene.boxes.size() + 1);
    const std::optional<Eigen::Vector2d> place = view.floorPlace(draws);
    if (!place) continue;
    box.position_m = *place;
    if (!fits(options, view, scene, box)) continue;
    scene.boxes.push_back(box);
    return true;
  }
  return false;
}

/// The same view in an image of this width.
void shrink(Camera& camera, int width) {
  const double ratio = static_cast<double>(width) / camera.width_px;
  camera.height_px = std::max(2, camera.height_px * width / camera.width_px);
  camera.width_px = width;
  if (!camera.intrinsics) return;
  Intrinsics& own = *camera.intrinsics;
  own = {ratio * own.fx_px, ratio * own.fy_px, ratio * (own.cx_px + 0.5) - 0.5,
         ratio * (own.cy_px + 0.5) - 0.5};
}

bool topsVisible(const RandomSceneOptions& options, Scene scene) {
  if (!(options.min_top_visibility > 0.0)) return true;
  shrink(scene.camera, std::min(scene.camera.width_px, kPreviewWidth));
  for (const double visibility : capture(scene, 0).top_visibility) {
    if (visibility < options.min_top_visibility) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> problems(const RandomSceneOptions& options) {
  std::vector<std::string> lines;
  const auto require = [&](bool holds, const std::string& line) {
    if (!holds) lines.push_back(line);
  };
  require(options.boxes_min >= 0 && options.boxes_min <= options.boxes_max && options.boxes_max <= 1000,
          "boxes_min, boxes_max: not 0 <= min <= max <= 1000");
  require((options.box_size_min_m.array() > 0.0).all() &&
              (options.box_size_min_m.array() <= options.box_size_max_m.array()).all() &&
              (options.box_size_max_m.array() <= 100.0).all(),
          "box_size_min_m, box_size_max_m: not 0 < min <= max <= 100 m");
  require(options.gap_m >= 0.0 && options.gap_m <= 100.0, "gap_m: not in [0, 100] m");
  require(options.distance_min_m > 0.0 && options.distance_min_m <= options.distance_max_m &&
              options.distance_max_m <= 100.0,
          "distance_min_m, distance_max_m: not 0 < min <= max <= 100 m");
  require(options.tilt_min_rad >= 0.0 && options.tilt_min_rad <= options.tilt_max_rad &&
              options.tilt_max_rad < 1.5,
          "tilt_min_rad, tilt_max_rad: not 0 <= min <= max < 1.5");
  require(options.target_offset_max_m >= 0.0 && options.target_offset_max_m <= 100.0,
          "target_offset_max_m: not in [0, 100] m");
  require(options.border_px_ratio >= 0.0 && options.border_px_ratio < 0.5,
          "border_px_ratio: not in [0, 0.5)");
  require(options.min_top_visibility >= 0.0 && options.min_top_visibility <= 1.0,
          "min_top_visibility: not in [0, 1]");
  Scene scene = options.scene;
  scene.boxes.clear();
  scene.camera.world_from_camera = lookAt(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero());  // drawn later
  for (const std::string& problem : problems(scene)) lines.push_back("scene." + problem);
  return lines;
}

Scene randomScene(const RandomSceneOptions& options, std::uint64_t seed) {
  std::string text;
  for (const std::string& problem : problems(options)) text += "\n" + problem;
  if (!text.empty()) throw std::invalid_argument("randomScene: the options are broken:" + text);
  Draws draws(seed);
  const int boxes = draws.integer(options.boxes_min, options.boxes_max);
  for (int attempt = 0; attempt < kSceneAttempts; ++attempt) {
    Scene scene = options.scene;
    scene.boxes.clear();
    if (!drawCamera(options, draws, scene)) continue;
    const View view(scene.camera, options.border_px_ratio);
    bool complete = true;
    for (int i = 0; i < boxes && complete; ++i) complete = drawBox(options, view, draws, scene);
    if (complete && topsVisible(options, scene)) return scene;
  }
  throw std::runtime_error("randomScene: no room for " + std::to_string(boxes) +
                           " boxes before the camera; fewer or smaller ones, or more distance, are needed");
}

}  // namespace mixed_palletizing::simulation
