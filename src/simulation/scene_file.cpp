#include <stdexcept>

#include <mixed_palletizing/simulation/scene_file.hpp>
#include <mixed_palletizing/simulation/yaml_text.hpp>

#include "scene_sections.hpp"
#include "scene_setting.hpp"

namespace mixed_palletizing::simulation {
namespace {

void readFloor(YamlSection section, Floor& floor) {
  Eigen::Vector2d size(floor.size_x_m, floor.size_y_m);
  section.read("size_m", size);
  floor.size_x_m = size.x();
  floor.size_y_m = size.y();
  section.read("rgb", floor.rgb);
  floor.texture = section.readTexture("texture");
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
  for (YamlSection& entry : file.list("markers")) readMarker(entry, scene.markers.emplace_back());
  for (YamlSection& board : file.list("boards")) readBoard(board, scene.boards.emplace_back());
  for (YamlSection& surface : file.list("surfaces")) readSurface(surface, scene.surfaces.emplace_back());
  for (YamlSection& object : file.list("objects")) readObject(object, scene.objects.emplace_back());
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
  const bool is_ideal = readCamera(file.section("camera"), with_camera_pose, scene.camera);
  readNoise(file.section("noise"), scene.noise);
  if (is_ideal) scene.noise = Noise();
}

YAML::Node parseYaml(const std::string& path) {
  const std::string text = readYamlText(path);
  try {
    return parseYamlText(text);
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
