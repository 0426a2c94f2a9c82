#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <mixed_palletizing/simulation/scene_file.hpp>

#include "scene_setting.hpp"
#include "yaml_section.hpp"

namespace mixed_palletizing::simulation {
namespace {

void readFloor(YamlSection section, Floor& floor) {
  Eigen::Vector2d size(floor.size_x_m, floor.size_y_m);
  section.read("size_m", size);
  floor.size_x_m = size.x();
  floor.size_y_m = size.y();
  section.read("rgb", floor.rgb);
  section.finish();
}

void readMarker(YamlSection section, Marker& marker) {
  section.read("dictionary", marker.dictionary);
  section.read("id", marker.id);
  section.read("side_m", marker.side_m);
  section.read("quiet_zone_m", marker.quiet_zone_m);
  section.read("inverted", marker.inverted);
  section.read("position_m", marker.position_m);
  section.readAngle("yaw", marker.yaw_rad);
  section.finish();
}

void readCameraPose(YamlSection& section, geometry::Pose& world_from_camera) {
  const bool by_points = section.has("eye_m") && section.has("target_m");
  const bool by_matrix = section.has("world_from_camera");
  Eigen::Vector3d eye = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  section.read("eye_m", eye);
  section.read("target_m", target);
  section.read("world_from_camera", world_from_camera.matrix());
  const bool any_point = section.has("eye_m") || section.has("target_m");
  if (by_matrix ? any_point : !by_points) {
    section.add("pose", "give either eye_m and target_m or world_from_camera");
  } else if (by_points && (target - eye).norm() < 1e-9) {
    section.add("eye_m", "is the same point as target_m");
  } else if (by_points) {
    world_from_camera = lookAt(eye, target);
  }
  if (world_from_camera.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    section.add("world_from_camera", "its last row is not 0 0 0 1");
  }
}

void readCamera(YamlSection section, bool with_pose, Camera& camera) {
  section.read("width_px", camera.width_px);
  section.read("height_px", camera.height_px);
  section.readAngle("horizontal_fov", camera.horizontal_fov_rad);
  if (with_pose) readCameraPose(section, camera.world_from_camera);
  if (section.has("projector_m")) camera.projector_m = Eigen::Vector3d::Zero();
  if (camera.projector_m) section.read("projector_m", *camera.projector_m);
  section.finish();
}

void readLabel(YamlSection section, BoxLabel& label) {
  section.read("center_m", label.center_m);
  section.read("size_m", label.size_m);
  section.read("rgb", label.rgb);
  section.read("down_sides", label.down_sides);
  section.finish();
}

void readFaceColors(YamlSection section, SceneBox& box) {
  const std::array<std::pair<const char*, BoxFace>, 6> faces = {{{"minus_x", BoxFace::kMinusX},
                                                                 {"plus_x", BoxFace::kPlusX},
                                                                 {"minus_y", BoxFace::kMinusY},
                                                                 {"plus_y", BoxFace::kPlusY},
                                                                 {"bottom", BoxFace::kBottom},
                                                                 {"top", BoxFace::kTop}}};
  for (const auto& [name, face] : faces) {
    if (!section.has(name)) continue;
    std::uint32_t rgb = box.rgb;
    section.read(name, rgb);
    box.face_rgb[static_cast<std::size_t>(face)] = rgb;
  }
  section.finish();
}

BoxFace readSide(YamlSection& section) {
  const std::array<std::pair<const char*, BoxFace>, 4> sides = {{{"minus_x", BoxFace::kMinusX},
                                                                 {"plus_x", BoxFace::kPlusX},
                                                                 {"minus_y", BoxFace::kMinusY},
                                                                 {"plus_y", BoxFace::kPlusY}}};
  std::string text = "plus_x";
  section.read("side", text);
  for (const auto& [name, face] : sides) {
    if (text == name) return face;
  }
  section.add("side", "'" + text + "' is none of minus_x, plus_x, minus_y, plus_y");
  return BoxFace::kPlusX;
}

void readShape(YamlSection section, BoxShape& shape) {
  section.read("bulge_m", shape.bulge_m);
  section.read("rounding_m", shape.rounding_m);
  for (YamlSection& entry : section.list("dents")) {
    BoxDent& dent = shape.dents.emplace_back();
    entry.read("center_m", dent.center_m);
    entry.read("radius_m", dent.radius_m);
    entry.read("depth_m", dent.depth_m);
    entry.finish();
  }
  for (YamlSection& entry : section.list("flaps")) {
    BoxFlap& flap = shape.flaps.emplace_back();
    flap.side = readSide(entry);
    entry.read("length_m", flap.length_m);
    entry.readAngle("angle", flap.angle_rad);
    entry.finish();
  }
  section.finish();
}

void readBox(YamlSection section, SceneBox& box) {
  section.read("name", box.name);
  section.read("size_m", box.size_m);
  section.read("position_m", box.position_m);
  section.read("base_z_m", box.base_z_m);
  section.readAngle("yaw", box.yaw_rad);
  section.read("rgb", box.rgb);
  readFaceColors(section.section("face_rgb"), box);
  for (YamlSection& label : section.list("labels")) readLabel(label, box.labels.emplace_back());
  readShape(section.section("shape"), box.shape);
  section.finish();
}

void readNoise(YamlSection section, Noise& noise) {
  section.read("depth_stddev_at_1m_m", noise.depth_stddev_at_1m_m);
  section.read("no_data_on_black", noise.no_data_on_black);
  section.read("dropout_ratio", noise.dropout_ratio);
  section.read("flying_pixel_ratio", noise.flying_pixel_ratio);
  section.read("depth_edge_m", noise.depth_edge_m);
  section.read("dark_noise_gain", noise.dark_noise_gain);
  section.read("grazing_noise_gain", noise.grazing_noise_gain);
  section.finish();
}

Scene readScene(YamlSection file) {
  Scene scene;
  readSetting(file, true, scene);
  for (YamlSection& box : file.list("boxes")) readBox(box, scene.boxes.emplace_back());
  file.finish();
  return scene;
}

}  // namespace

void readSetting(YamlSection& file, bool with_camera_pose, Scene& scene) {
  readFloor(file.section("floor"), scene.floor);
  const YAML::Node marker = file.take("marker");
  scene.has_marker = !(marker.IsDefined() && marker.IsScalar() && marker.Scalar() == "none");
  if (scene.has_marker) readMarker(file.section("marker"), scene.marker);
  readCamera(file.section("camera"), with_camera_pose, scene.camera);
  readNoise(file.section("noise"), scene.noise);
}

YAML::Node parseYaml(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();  // an empty file is a sound one
  if (!file.is_open() || file.bad())
    throw std::runtime_error(path + ": cannot read: " + std::strerror(errno));
  try {
    return YAML::Load(text.str());
  } catch (const YAML::ParserException& error) {
    throw std::invalid_argument(path + ":" + std::to_string(error.mark.line + 1) + ": no YAML: " + error.msg);
  }
}

Scene loadScene(const std::string& path) {
  YamlReport report(path);
  Scene scene = readScene(YamlSection(parseYaml(path), "", report));
  report.throwIfAny();
  for (const std::string& problem : problems(scene)) {
    const std::size_t colon = problem.find(": ");
    report.add(problem.substr(0, colon), problem.substr(colon + 2));
  }
  report.throwIfAny();
  return scene;
}

}  // namespace mixed_palletizing::simulation
