#include <cmath>
#include <sstream>

#include <mixed_palletizing/simulation/recipe.hpp>

namespace mixed_palletizing::simulation {
namespace {

constexpr double kMaxLength = 100.0;    // [m]: a larger number is a length in millimetres
constexpr double kMaxDeviation = 0.03;  // [m] of a top from its plane
constexpr int kMaxBoxes = 1000;
constexpr double kPi = 3.14159265358979323846;
constexpr double kTiny = 1e-12;  // left by the conversion from degrees

/// Collects broken rules.
class RecipeRules {
 public:
  void require(bool holds, const std::string& key, const std::string& what) {
    if (!holds) lines_.push_back(key + ": " + what);
  }
  void range(const std::string& key, const Range& range, double low, double high, double scale = 1.0) {
    std::ostringstream what;
    what << "[" << range.min * scale << ", " << range.max * scale << "] is no range within [" << low * scale
         << ", " << high * scale << "]";
    require(range.min >= low - kTiny && range.min <= range.max && range.max <= high + kTiny, key, what.str());
  }
  void angles(const std::string& key, const Range& range_rad, double low, double high) {
    range(key, range_rad, low, high, 180.0 / kPi);
  }
  /// Lengths above zero.
  void sizes(const std::string& key, const Range& range) {
    this->range(key, range, kLeastLength, kMaxLength);
  }
  void counts(const std::string& key, const CountRange& range, int low) {
    std::ostringstream what;
    what << "[" << range.min << ", " << range.max << "] is no range within [" << low << ", " << kMaxBoxes
         << "]";
    require(range.min >= low && range.min <= range.max && range.max <= kMaxBoxes, key, what.str());
  }
  void colors(const std::string& key, const std::vector<std::uint32_t>& colors, bool may_be_empty) {
    require(may_be_empty || !colors.empty(), key, "is empty");
    for (const std::uint32_t color : colors) {
      require(color <= 0xffffffu, key, std::to_string(color) + " is not a colour 0xRRGGBB");
    }
  }
  void ratio(const std::string& key, double value) {
    require(value >= 0.0 && value <= 1.0, key, "is not in [0, 1]");
  }
  void add(const std::string& line) { lines_.push_back(line); }

  std::vector<std::string> lines() { return std::move(lines_); }

 private:
  static constexpr double kLeastLength = 1e-3;
  std::vector<std::string> lines_;
};

void checkView(const RecipeView& view, RecipeRules& rules) {
  rules.sizes("view.distance_m", view.distance_m);
  rules.angles("view.tilt_deg", view.tilt_rad, 0.0, 85.0 * kPi / 180.0);
  rules.angles("view.azimuth_deg", view.azimuth_rad, -2.0 * kPi, 2.0 * kPi);
  rules.range("view.target_offset_m", view.target_offset_m, 0.0, kMaxLength);
  rules.require(view.border_px_ratio >= 0.0 && view.border_px_ratio < 0.5, "view.border_px_ratio",
                "is not in [0, 0.5)");
}

void checkSensor(const RecipeSensor& sensor, RecipeRules& rules) {
  const Range off;
  rules.range("sensor.depth_stddev_at_1m_m", sensor.depth_stddev_at_1m_m.value_or(off), 0.0, 0.1);
  rules.range("sensor.dropout_ratio", sensor.dropout_ratio.value_or(off), 0.0, 1.0);
  rules.range("sensor.flying_pixel_ratio", sensor.flying_pixel_ratio.value_or(off), 0.0, 1.0);
  rules.colors("sensor.floor_rgb", sensor.floor_rgb, true);
}

void checkBoxes(const RecipeBoxes& boxes, RecipeRules& rules) {
  rules.sizes("boxes.size_x_m", boxes.size_x_m);
  rules.sizes("boxes.size_y_m", boxes.size_y_m);
  rules.sizes("boxes.size_z_m", boxes.size_z_m);
  rules.angles("boxes.yaw_deg", boxes.yaw_rad, -2.0 * kPi, 2.0 * kPi);
  const Range middle;
  rules.range("boxes.x_m", boxes.x_m.value_or(middle), -kMaxLength, kMaxLength);
  rules.range("boxes.y_m", boxes.y_m.value_or(middle), -kMaxLength, kMaxLength);
  rules.require(boxes.gap_m >= 0.0 && boxes.gap_m <= kMaxLength, "boxes.gap_m", "is not in [0, 100] m");
}

void checkPaint(const RecipePaint& paint, RecipeRules& rules) {
  rules.colors("paint.carton_rgb", paint.carton_rgb, false);
  rules.counts("paint.labels", paint.labels, 0);
  rules.sizes("paint.label_size_m", paint.label_size_m);
  rules.colors("paint.label_rgb", paint.label_rgb, false);
  rules.ratio("paint.band_ratio", paint.band_ratio);
  rules.sizes("paint.band_width_m", paint.band_width_m);
  rules.colors("paint.band_rgb", paint.band_rgb, false);
}

/// Finer bounds depend on each box: see problems(Scene).
void checkShape(const RecipeShape& shape, RecipeRules& rules) {
  rules.ratio("shape.bulge_ratio", shape.bulge_ratio);
  rules.range("shape.bulge_m", shape.bulge_m, -kMaxDeviation, kMaxDeviation);
  rules.ratio("shape.rounding_ratio", shape.rounding_ratio);
  rules.range("shape.rounding_m", shape.rounding_m, 0.0, kMaxDeviation);
  rules.counts("shape.dents", shape.dents, 0);
  rules.range("shape.dent_radius_m", shape.dent_radius_m, 0.002, kMaxLength);
  rules.range("shape.dent_depth_m", shape.dent_depth_m, 1e-4, kMaxDeviation);
  rules.ratio("shape.flap_ratio", shape.flap_ratio);
  rules.sizes("shape.flap_length_m", shape.flap_length_m);
  rules.angles("shape.flap_angle_deg", shape.flap_angle_rad, 0.0, 1.5 * kPi);
}

void checkGroup(const RecipeGroup& group, const std::string& key, RecipeRules& rules) {
  rules.counts(key + ".count", group.count, 0);
  rules.range(key + ".top_visibility", group.top_visibility, 0.0, 1.0);
  rules.counts(key + ".boxes", group.boxes, 1);
  rules.range(key + ".gap_m", group.gap_m, 0.0, kMaxLength);
  rules.range(key + ".contact_ratio", group.contact_ratio, 0.0, 1.0);
  rules.range(key + ".height_step_m", group.height_step_m, 0.0, kMaxLength);
  rules.angles(key + ".bearing_deg", group.bearing_rad, -kPi, kPi);
  rules.sizes(key + ".length_x_m", group.length_x_m);
  rules.sizes(key + ".length_y_m", group.length_y_m);
  rules.counts(key + ".layers", group.layers, 1);
  rules.range(key + ".pallet_height_m", group.pallet_height_m, 0.0, kMaxLength);
  rules.range(key + ".fill_ratio", group.fill_ratio, 0.0, 1.0);
}

}  // namespace

std::vector<std::string> problems(const Recipe& recipe) {
  RecipeRules rules;
  Scene scene = recipe.scene;
  scene.boxes.clear();
  scene.camera.world_from_camera = lookAt(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero());  // drawn later
  for (const std::string& problem : problems(scene)) rules.add(problem);
  checkView(recipe.view, rules);
  checkSensor(recipe.sensor, rules);
  checkBoxes(recipe.boxes, rules);
  checkPaint(recipe.paint, rules);
  checkShape(recipe.shape, rules);
  for (std::size_t i = 0; i < recipe.groups.size(); ++i) {
    checkGroup(recipe.groups[i], "groups[" + std::to_string(i) + "]", rules);
  }
  rules.counts("boxes_total", recipe.boxes_total, 0);
  return rules.lines();
}

}  // namespace mixed_palletizing::simulation
