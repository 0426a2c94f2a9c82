#include <cmath>
#include <sstream>

#include <mixed_palletizing/geometry/rectangle.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

#include "marker_picture.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr int kMaxPixels = 64 * 1024 * 1024;
constexpr std::size_t kMaxBoxes = 65535;  // the mask has 16 bits
constexpr double kMaxLength = 100.0;      // [m]: a larger number is a length in millimetres
constexpr double kAllowedOverlap = 1e-4;  // [m]
constexpr double kMaxFocal = 1e7;         // [px]
constexpr double kMaxGain = 100.0;
constexpr double kMaxBulge = 0.03;     // [m]
constexpr double kMaxRounding = 0.02;  // [m]
constexpr double kMaxDent = 0.03;      // [m]
constexpr std::size_t kMaxDents = 32;  // of a box
constexpr double kPi = 3.14159265358979323846;

/// Collects broken rules.
class Rules {
 public:
  template <typename T>
  void require(bool holds, const std::string& key, const T& value, const std::string& rule) {
    if (holds) return;
    std::ostringstream line;
    line << key << ": " << value << " " << rule;
    lines_.push_back(line.str());
  }
  void length(const std::string& key, double value) {
    require(value > 0.0 && value <= kMaxLength, key, value, "is not a length in (0, 100] m");
  }
  template <typename Vector>
  void lengths(const std::string& key, const Vector& value) {
    const bool holds = (value.array() > 0.0).all() && (value.array() <= kMaxLength).all();
    require(holds, key, value.transpose(), "are not lengths in (0, 100] m");
  }
  template <typename Vector>
  void place(const std::string& key, const Vector& value) {
    require((value.array().abs() <= kMaxLength).all(), key, value.transpose(), "is not a place within 100 m");
  }
  void angle(const std::string& key, double value) {
    require(std::isfinite(value), key, value, "is not an angle");
  }
  void ratio(const std::string& key, double value) {
    require(value >= 0.0 && value <= 1.0, key, value, "is not in [0, 1]");
  }
  void color(const std::string& key, std::uint32_t value) {
    require(value <= 0xffffffu, key, value, "is not a colour 0xRRGGBB");
  }
  void add(const std::string& key, const std::string& what) { lines_.push_back(key + ": " + what); }

  bool empty() const { return lines_.empty(); }
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

void checkMarker(const Scene& scene, Rules& rules) {
  const Marker& marker = scene.marker;
  const int count = markerCount(marker.dictionary);
  rules.require(count > 0, "marker.dictionary", "'" + marker.dictionary + "'", "is no dictionary of OpenCV");
  if (count > 0) {
    rules.require(marker.id >= 0 && marker.id < count, "marker.id", marker.id,
                  "is not in [0, " + std::to_string(count - 1) + "]");
  }
  rules.length("marker.side_m", marker.side_m);
  rules.require(marker.quiet_zone_m >= 0.0 && marker.quiet_zone_m <= kMaxLength, "marker.quiet_zone_m",
                marker.quiet_zone_m, "is not in [0, 100] m");
  rules.angle("marker.yaw", marker.yaw_rad);
  const Eigen::Vector2d floor(scene.floor.size_x_m, scene.floor.size_y_m);
  rules.require((marker.position_m.array().abs() <= 0.5 * floor.array()).all(), "marker.position_m",
                marker.position_m.transpose(), "is not on the floor");
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
  const Eigen::Matrix3d rotation = camera.world_from_camera.linear();
  const bool rigid = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-6 &&
                     rotation.determinant() > 0.0;
  if (!rigid) rules.add("camera.world_from_camera", "its rotation is none");
  const Eigen::Vector3d eye = camera.world_from_camera.translation();
  rules.place("camera.world_from_camera", eye);
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

void checkShape(const SceneBox& box, const std::string& key, Rules& rules) {
  const BoxShape& shape = box.shape;
  const double least = box.size_m.minCoeff();
  rules.require(std::abs(shape.bulge_m) <= std::min(kMaxBulge, 0.5 * box.size_m.z()), key + ".bulge_m",
                shape.bulge_m, "is not within 0.03 m and half the height");
  rules.require(shape.rounding_m >= 0.0 && shape.rounding_m <= std::min(kMaxRounding, 0.25 * least),
                key + ".rounding_m", shape.rounding_m,
                "is not in [0, 0.02] m and a quarter of the least side");
  rules.require(shape.dents.size() <= kMaxDents, key + ".dents", shape.dents.size(),
                "dents are more than 32");
  for (std::size_t i = 0; i < shape.dents.size(); ++i) {
    const BoxDent& dent = shape.dents[i];
    const std::string dent_key = key + ".dents[" + std::to_string(i) + "]";
    const bool on_top = (dent.center_m.array().abs() <= 0.5 * box.size_m.head<2>().array()).all();
    rules.require(on_top, dent_key + ".center_m", dent.center_m.transpose(), "is not on the top");
    rules.require(dent.radius_m >= 0.002 && dent.radius_m <= kMaxLength, dent_key + ".radius_m",
                  dent.radius_m, "is not in [0.002, 100] m");
    rules.require(dent.depth_m > 0.0 && dent.depth_m <= std::min(kMaxDent, 0.25 * box.size_m.z()),
                  dent_key + ".depth_m", dent.depth_m, "is not in (0, 0.03] m and a quarter of the height");
  }
  for (std::size_t i = 0; i < shape.flaps.size(); ++i) {
    const BoxFlap& flap = shape.flaps[i];
    const std::string flap_key = key + ".flaps[" + std::to_string(i) + "]";
    rules.require(flap.side < BoxFace::kBottom, flap_key + ".side", static_cast<int>(flap.side),
                  "is no side");
    rules.require(flap.length_m > 0.0 && flap.length_m <= box.size_m.maxCoeff(), flap_key + ".length_m",
                  flap.length_m, "is not in (0, longest side of the box] m");
    rules.require(flap.angle_rad >= 0.0 && flap.angle_rad <= 1.5 * kPi, flap_key + ".angle",
                  flap.angle_rad * 180.0 / kPi, "is not in [0, 270] degrees");
  }
}

void checkBox(const SceneBox& box, const std::string& key, Rules& rules) {
  rules.lengths(key + ".size_m", box.size_m);
  rules.place(key + ".position_m", box.position_m);
  rules.require(box.base_z_m >= 0.0 && box.base_z_m <= kMaxLength, key + ".base_z_m", box.base_z_m,
                "is not in [0, 100] m");
  rules.angle(key + ".yaw", box.yaw_rad);
  rules.color(key + ".rgb", box.rgb);
  for (const auto& rgb : box.face_rgb) rules.color(key + ".face_rgb", rgb.value_or(0));
  for (std::size_t i = 0; i < box.labels.size(); ++i) {
    const std::string label = key + ".labels[" + std::to_string(i) + "]";
    rules.place(label + ".center_m", box.labels[i].center_m);
    rules.lengths(label + ".size_m", box.labels[i].size_m);
    rules.color(label + ".rgb", box.labels[i].rgb);
  }
  checkShape(box, key + ".shape", rules);
}

/// Whether two solids share more than touching faces.
bool overlap(const SceneBox& a, const SceneBox& b) {
  const double low = std::max(a.base_z_m, b.base_z_m);
  const auto topOf = [](const SceneBox& box) {
    return box.base_z_m + box.size_m.z() + std::max(0.0, box.shape.bulge_m);
  };
  const double high = std::min(topOf(a), topOf(b));
  if (high - low <= kAllowedOverlap) return false;
  const auto shrunk = [](const SceneBox& box) {
    const Eigen::Vector2d size = (box.size_m.head<2>().array() - kAllowedOverlap).max(0.0);
    return geometry::Rectangle{box.position_m, box.yaw_rad, size};
  };
  return !(geometry::distance(shrunk(a), shrunk(b)) > 0.0);
}

void checkSolids(const Scene& scene, Rules& rules) {
  const auto key = [](std::size_t i) { return "boxes[" + std::to_string(i) + "]"; };
  const Eigen::Vector3d eye = scene.camera.world_from_camera.translation();
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    const Eigen::Vector3d inside = worldFromBox(scene.boxes[i]).inverse() * eye;
    if ((inside.cwiseAbs().array() <= 0.5 * scene.boxes[i].size_m.array()).all()) {
      rules.add(key(i), "holds the camera");
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(scene.boxes[i], scene.boxes[j])) rules.add(key(i), "overlaps " + key(j));
    }
  }
}

}  // namespace

std::vector<std::string> problems(const Scene& scene) {
  Rules rules;
  rules.length("floor.size_m", scene.floor.size_x_m);
  rules.length("floor.size_m", scene.floor.size_y_m);
  rules.color("floor.rgb", scene.floor.rgb);
  if (scene.has_marker) checkMarker(scene, rules);
  checkCamera(scene.camera, rules);
  checkNoise(scene.noise, rules);
  rules.require(scene.boxes.size() <= kMaxBoxes, "boxes", scene.boxes.size(), "boxes are more than 65535");
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    checkBox(scene.boxes[i], "boxes[" + std::to_string(i) + "]", rules);
  }
  if (rules.empty()) checkSolids(scene, rules);  // needs sane numbers
  return rules.lines();
}

}  // namespace mixed_palletizing::simulation
