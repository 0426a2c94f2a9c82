#include <array>
#include <utility>

#include <mixed_palletizing/simulation/recipe.hpp>

#include "scene_setting.hpp"
#include "yaml_section.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

/// [min, max], or one number for both.
void read(YamlSection& section, const std::string& name, Range& range) {
  if (!section.has(name)) return;
  Eigen::Vector2d ends(range.min, range.max);
  if (section.peek(name).IsSequence()) {
    section.read(name, ends);
  } else {
    section.read(name, ends.x());
    ends.y() = ends.x();
  }
  range = {ends.x(), ends.y()};
}

void read(YamlSection& section, const std::string& name, std::optional<Range>& range) {
  if (!section.has(name)) return;
  range.emplace();
  read(section, name, *range);
}

void readAngles(YamlSection& section, const std::string& name, Range& range_rad) {
  Range range_deg{range_rad.min / kRadPerDeg, range_rad.max / kRadPerDeg};
  if (!section.has(name + "_deg")) return;
  read(section, name + "_deg", range_deg);
  range_rad = {range_deg.min * kRadPerDeg, range_deg.max * kRadPerDeg};
}

void read(YamlSection& section, const std::string& name, CountRange& range) {
  if (!section.has(name)) return;
  std::vector<int> ends;
  section.read(name, ends);
  if (ends.size() == 1 || ends.size() == 2) {
    range = {ends.front(), ends.back()};
  } else {
    section.add(name, "is no integer or list of 2 integers");
  }
}

void readView(YamlSection section, RecipeView& view) {
  read(section, "distance_m", view.distance_m);
  readAngles(section, "tilt", view.tilt_rad);
  readAngles(section, "azimuth", view.azimuth_rad);
  read(section, "target_offset_m", view.target_offset_m);
  section.read("border_px_ratio", view.border_px_ratio);
  section.read("marker_in_sight", view.marker_in_sight);
  section.finish();
}

void readSensor(YamlSection section, RecipeSensor& sensor) {
  read(section, "depth_stddev_at_1m_m", sensor.depth_stddev_at_1m_m);
  read(section, "dropout_ratio", sensor.dropout_ratio);
  read(section, "flying_pixel_ratio", sensor.flying_pixel_ratio);
  section.read("floor_rgb", sensor.floor_rgb);
  section.finish();
}

void readBoxes(YamlSection section, RecipeBoxes& boxes) {
  read(section, "size_x_m", boxes.size_x_m);
  read(section, "size_y_m", boxes.size_y_m);
  read(section, "size_z_m", boxes.size_z_m);
  readAngles(section, "yaw", boxes.yaw_rad);
  read(section, "x_m", boxes.x_m);
  read(section, "y_m", boxes.y_m);
  section.read("gap_m", boxes.gap_m);
  section.finish();
}

void readPaint(YamlSection section, RecipePaint& paint) {
  section.read("carton_rgb", paint.carton_rgb);
  read(section, "labels", paint.labels);
  read(section, "label_size_m", paint.label_size_m);
  section.read("label_rgb", paint.label_rgb);
  section.read("band_ratio", paint.band_ratio);
  read(section, "band_width_m", paint.band_width_m);
  section.read("band_rgb", paint.band_rgb);
  section.finish();
}

void readShape(YamlSection section, RecipeShape& shape) {
  section.read("bulge_ratio", shape.bulge_ratio);
  read(section, "bulge_m", shape.bulge_m);
  section.read("rounding_ratio", shape.rounding_ratio);
  read(section, "rounding_m", shape.rounding_m);
  read(section, "dents", shape.dents);
  read(section, "dent_radius_m", shape.dent_radius_m);
  read(section, "dent_depth_m", shape.dent_depth_m);
  section.read("flap_ratio", shape.flap_ratio);
  read(section, "flap_length_m", shape.flap_length_m);
  readAngles(section, "flap_angle", shape.flap_angle_rad);
  section.finish();
}

const std::array<std::pair<const char*, Arrangement>, 5> kArrangements = {
    {{"apart", Arrangement::kApart},
     {"touching", Arrangement::kTouching},
     {"hidden", Arrangement::kHidden},
     {"cut", Arrangement::kCut},
     {"stack", Arrangement::kStack}}};

void readArrangement(YamlSection& section, Arrangement& arrangement) {
  std::string name = "apart";
  section.read("arrangement", name);
  std::string names;
  for (const auto& [known, value] : kArrangements) {
    if (name == known) {
      arrangement = value;
      return;
    }
    names += std::string(names.empty() ? "" : ", ") + known;
  }
  section.add("arrangement", "'" + name + "' is none of " + names);
}

/// Only the keys that mean something to the arrangement are known.
void readGroup(YamlSection section, RecipeGroup& group) {
  readArrangement(section, group.arrangement);
  read(section, "count", group.count);
  read(section, "top_visibility", group.top_visibility);
  const bool is_touching = group.arrangement == Arrangement::kTouching;
  const bool is_hidden = group.arrangement == Arrangement::kHidden;
  const bool is_stack = group.arrangement == Arrangement::kStack;
  if (is_touching || is_hidden || is_stack) {
    read(section, "gap_m", group.gap_m);
    read(section, "height_step_m", group.height_step_m);
  }
  if (is_touching) {
    read(section, "boxes", group.boxes);
    read(section, "contact_ratio", group.contact_ratio);
  }
  if (is_hidden) readAngles(section, "bearing", group.bearing_rad);
  if (is_stack) {
    read(section, "length_x_m", group.length_x_m);
    read(section, "length_y_m", group.length_y_m);
    read(section, "layers", group.layers);
    read(section, "pallet_height_m", group.pallet_height_m);
    read(section, "fill_ratio", group.fill_ratio);
  }
  section.finish();
}

Recipe readRecipe(YamlSection file) {
  Recipe recipe;
  file.read("about", recipe.about);
  readSetting(file, false, recipe.scene);
  readView(file.section("view"), recipe.view);
  readSensor(file.section("sensor"), recipe.sensor);
  readBoxes(file.section("boxes"), recipe.boxes);
  readPaint(file.section("paint"), recipe.paint);
  readShape(file.section("shape"), recipe.shape);
  if (file.has("groups")) recipe.groups.clear();
  for (YamlSection& group : file.list("groups")) readGroup(group, recipe.groups.emplace_back());
  read(file, "boxes_total", recipe.boxes_total);
  file.finish();
  return recipe;
}

/// "a/separated.yaml" -> "separated".
std::string stemOf(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.substr(0, file.find_last_of('.'));
}

}  // namespace

Recipe loadRecipe(const std::string& path) {
  YamlReport report(path);
  Recipe recipe = readRecipe(YamlSection(parseYaml(path), "", report));
  recipe.name = stemOf(path);
  report.throwIfAny();
  for (const std::string& problem : problems(recipe)) {
    const std::size_t colon = problem.find(": ");
    report.add(problem.substr(0, colon), problem.substr(colon + 2));
  }
  report.throwIfAny();
  return recipe;
}

}  // namespace mixed_palletizing::simulation
