#include <cmath>
#include <set>

#include "printed_board.hpp"
#include "rules.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr int kMaxPixels = 64 * 1024 * 1024;
constexpr std::size_t kMaxThings = 65535;  // the mask has 16 bits
constexpr int kMaxMarkers = 1000;          // of a board
constexpr double kMaxFocal = 1e7;          // [px]
constexpr double kMaxGain = 100.0;
constexpr double kPi = 3.14159265358979323846;

/// `count` markers, the first of which is `marker`; `id` is the key of its number.
void checkMarker(const Scene& scene, const Marker& marker, int count, const std::string& key,
                 const std::string& id, Rules& rules) {
  const int known = markerCount(marker.dictionary);
  rules.require(known > 0, key + ".dictionary", "'" + marker.dictionary + "'", "is no dictionary of OpenCV");
  if (known > 0) {
    rules.require(marker.id >= 0 && marker.id <= known - count, key + id, marker.id,
                  "is not in [0, " + std::to_string(known - count) + "]");
  }
  rules.length(key + ".side_m", marker.side_m);
  rules.require(marker.quiet_zone_m >= 0.0 && marker.quiet_zone_m <= kMaxLength, key + ".quiet_zone_m",
                marker.quiet_zone_m, "is not in [0, 100] m");
  rules.angle(key + ".yaw", marker.yaw_rad);
  Eigen::Vector2d size(scene.floor.size_x_m, scene.floor.size_y_m);
  bool is_there = marker.surface.empty();
  for (const SceneSurface& surface : scene.surfaces) {
    if (is_there || surface.name != marker.surface) continue;
    size = surface.size_m;
    is_there = true;
  }
  rules.require(is_there, key + ".surface", "'" + marker.surface + "'", "is no surface of the scene");
  rules.require((marker.position_m.array().abs() <= 0.5 * size.array()).all(), key + ".position_m",
                marker.position_m.transpose(),
                marker.surface.empty() ? "is not on the floor" : "is not on its surface");
}

void checkMarkers(const Scene& scene, Rules& rules) {
  if (scene.has_marker) {
    checkMarker(scene, scene.marker, 1, "marker", ".id", rules);
    rules.require(scene.marker.surface.empty(), "marker.surface", scene.marker.surface,
                  "is not the floor, where the marker of the base frame lies");
  }
  for (std::size_t i = 0; i < scene.markers.size(); ++i) {
    checkMarker(scene, scene.markers[i], 1, "markers[" + std::to_string(i) + "]", ".id", rules);
  }
  for (std::size_t i = 0; i < scene.boards.size(); ++i) {
    const MarkerBoard& board = scene.boards[i];
    const std::string key = "boards[" + std::to_string(i) + "]";
    const bool sane = board.columns >= 1 && board.rows >= 1 && board.columns <= kMaxMarkers &&
                      board.rows <= kMaxMarkers / board.columns;
    rules.require(sane, key + ".columns", std::to_string(board.columns) + " x " + std::to_string(board.rows),
                  "is no board of 1 to 1000 markers");
    rules.require(board.gap_m >= 0.0 && board.gap_m <= kMaxLength, key + ".gap_m", board.gap_m,
                  "is not in [0, 100] m");
    checkMarker(scene, board.first, sane ? board.columns * board.rows : 1, key, ".first_id", rules);
  }
}

void checkLens(const Camera& camera, Rules& rules) {
  if (!camera.intrinsics) {
    const double fov = camera.horizontal_fov_rad;
    rules.require(fov > 0.001 && fov < 3.1, "camera.horizontal_fov", fov * 180.0 / kPi,
                  "is not in (0.06, 177) degrees");
    return;
  }
  const Intrinsics& own = *camera.intrinsics;
  const auto focal = [&](const std::string& key, double value) {
    rules.require(value >= 1.0 && value <= kMaxFocal, key, value, "is not in [1, 1e7] pixels");
  };
  focal("camera.fx_px", own.fx_px);
  focal("camera.fy_px", own.fy_px);
  rules.require(std::abs(own.cx_px) <= kMaxFocal, "camera.cx_px", own.cx_px, "is not within 1e7 pixels");
  rules.require(std::abs(own.cy_px) <= kMaxFocal, "camera.cy_px", own.cy_px, "is not within 1e7 pixels");
}

void checkCamera(const Camera& camera, Rules& rules) {
  const bool size_ok = camera.width_px >= 2 && camera.height_px >= 2 && camera.width_px <= kMaxPixels / 2 &&
                       camera.height_px <= kMaxPixels / camera.width_px;
  const std::string size = std::to_string(camera.width_px) + " x " + std::to_string(camera.height_px);
  rules.require(size_ok, "camera.width_px", size, "is not an image of 2 x 2 to 64 million pixels");
  checkLens(camera, rules);
  rules.pose("camera.world_from_camera", camera.world_from_camera);
  const Eigen::Vector3d eye = camera.world_from_camera.translation();
  rules.require(eye.z() > 0.0, "camera.world_from_camera", eye.z(), "m is no height above the floor");
  if (camera.projector_m) {
    rules.place("camera.projector_m", *camera.projector_m);
    const double height = (camera.world_from_camera * *camera.projector_m).z();
    rules.require(height > 0.0, "camera.projector_m", height, "m is no height above the floor");
  }
}

void checkNoise(const Noise& noise, Rules& rules) {
  rules.require(noise.depth_stddev_at_1m_m >= 0.0 && noise.depth_stddev_at_1m_m <= 0.1,
                "noise.depth_stddev_at_1m_m", noise.depth_stddev_at_1m_m, "is not in [0, 0.1] m");
  rules.ratio("noise.dropout_ratio", noise.dropout_ratio);
  rules.ratio("noise.flying_pixel_ratio", noise.flying_pixel_ratio);
  rules.length("noise.depth_edge_m", noise.depth_edge_m);
  const auto gain = [&](const std::string& key, double value) {
    rules.require(value >= 0.0 && value <= kMaxGain, key, value, "is not in [0, 100]");
  };
  gain("noise.dark_noise_gain", noise.dark_noise_gain);
  gain("noise.grazing_noise_gain", noise.grazing_noise_gain);
}

void checkSurfaces(const Scene& scene, Rules& rules) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const std::string key = "surfaces[" + std::to_string(i) + "]";
    checkSurface(scene.surfaces[i], key, rules);
    const std::string& name = scene.surfaces[i].name;
    rules.require(!name.empty() && names.insert(name).second, key + ".name", "'" + name + "'",
                  "is empty or another surface's name");
  }
}

}  // namespace

std::vector<std::string> problems(const Scene& scene) {
  Rules rules;
  rules.length("floor.size_m", scene.floor.size_x_m);
  rules.length("floor.size_m", scene.floor.size_y_m);
  rules.color("floor.rgb", scene.floor.rgb);
  checkSurfaces(scene, rules);
  checkMarkers(scene, rules);
  checkCamera(scene.camera, rules);
  checkNoise(scene.noise, rules);
  const std::size_t things = scene.boxes.size() + scene.objects.size();
  rules.require(things <= kMaxThings, "boxes", things, "boxes and objects are more than 65535");
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    checkBox(scene.boxes[i], "boxes[" + std::to_string(i) + "]", rules);
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    checkObject(scene.objects[i], "objects[" + std::to_string(i) + "]", rules);
  }
  if (rules.empty()) checkSolids(scene, rules);  // needs sane numbers
  return rules.lines();
}

}  // namespace mixed_palletizing::simulation
