#include <algorithm>
#include <cmath>

#include "rules.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr double kMaxBulge = 0.03;     // [m]
constexpr double kMaxRounding = 0.02;  // [m]
constexpr double kMaxDent = 0.03;      // [m]
constexpr std::size_t kMaxDents = 32;  // of a box
constexpr double kPi = 3.14159265358979323846;

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

}  // namespace

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

}  // namespace mixed_palletizing::simulation
