#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/adapters/cell/simulator_options.hpp>
#include <mixed_palletizing/adapters/cloud_layout.hpp>
#include <mixed_palletizing/adapters/option_reader.hpp>

namespace mixed_palletizing::cell {
namespace {

constexpr double kRadPerDeg = M_PI / 180.0;
constexpr int kMostThreads = 256;

simulation::Camera sceneCamera(const CellCameraOptions& options) {
  simulation::Camera camera;
  camera.width_px = options.width_px;
  camera.height_px = options.height_px;
  camera.horizontal_fov_rad = options.horizontal_fov_deg * kRadPerDeg;
  const Eigen::Vector3d target(options.target_m[0], options.target_m[1], 0.0);
  const double tilt = options.tilt_deg * kRadPerDeg;
  const Eigen::Vector3d back(0.0, -std::sin(tilt), std::cos(tilt));
  camera.world_from_camera = simulation::lookAt(target + options.distance_m * back, target);
  return camera;
}

void readCamera(adapters::OptionReader reader, CellCameraOptions& options) {
  reader.read("distance_m", options.distance_m);
  reader.read("tilt_deg", options.tilt_deg);
  reader.read("horizontal_fov_deg", options.horizontal_fov_deg);
  reader.read("width_px", options.width_px);
  reader.read("height_px", options.height_px);
  reader.read("target_m", options.target_m);
}

void readScene(adapters::OptionReader& reader, CellSimulatorOptions& options) {
  adapters::OptionReader floor = reader.section("floor");
  floor.read("size_x_m", options.floor.size_x_m);
  floor.read("size_y_m", options.floor.size_y_m);
  adapters::OptionReader marker = reader.section("marker");
  marker.read("dictionary", options.marker.dictionary);
  marker.read("id", options.marker.id);
  marker.read("side_m", options.marker.side_m);
  marker.read("quiet_zone_m", options.marker.quiet_zone_m);
  marker.read("inverted", options.marker.inverted);
  adapters::OptionReader noise = reader.section("noise");
  noise.read("depth_stddev_at_1m_m", options.noise.depth_stddev_at_1m_m);
  noise.read("no_data_on_black", options.noise.no_data_on_black);
  noise.read("dropout_ratio", options.noise.dropout_ratio);
  noise.read("flying_pixel_ratio", options.noise.flying_pixel_ratio);
}

void readLayout(adapters::OptionReader reader, CellLayoutOptions& options) {
  reader.read("gap_m", options.gap_m);
  reader.read("border_px", options.border_px);
  reader.read("tries", options.tries);
}

std::vector<std::string> cameraProblems(const CellCameraOptions& options) {
  std::vector<std::string> all;
  const auto require = [&](bool holds, const std::string& key, double value, const std::string& what) {
    if (!holds) all.push_back("camera." + key + ": " + std::to_string(value) + " " + what);
  };
  require(options.distance_m > 0.1 && options.distance_m <= 20.0, "distance_m", options.distance_m,
          "is not in (0.1, 20] m");
  require(options.tilt_deg >= 0.0 && options.tilt_deg < 80.0, "tilt_deg", options.tilt_deg,
          "is not in [0, 80) degrees");
  if (options.target_m.size() != 2) all.emplace_back("camera.target_m: two numbers are needed, x and y");
  return all;
}

}  // namespace

CellSimulatorOptions::CellSimulatorOptions() {
  floor.size_x_m = floor.size_y_m = 8.0;
  noise.depth_stddev_at_1m_m = 0.0002;
  noise.no_data_on_black = true;
}

std::vector<std::string> problems(const CellSimulatorOptions& options) {
  std::vector<std::string> all = problems(options.order);
  const auto require = [&](bool holds, const std::string& line) {
    if (!holds) all.push_back(line);
  };
  require(options.n_pick >= 0, "n_pick: " + std::to_string(options.n_pick) + " is negative");
  require(!options.frame_id.empty(), "frame_id: a name is needed");
  const std::vector<std::string>& layouts = adapters::cloudLayoutNames();
  require(options.cloud_layout != "xyz" &&
              std::find(layouts.begin(), layouts.end(), options.cloud_layout) != layouts.end(),
          "cloud_layout: '" + options.cloud_layout + "' is no layout with colour");
  require(!options.base_frame.empty(), "base_frame: a name is needed");
  require(options.take_tolerance_m >= 0.0,
          "take_tolerance_m: " + std::to_string(options.take_tolerance_m) + " m is negative");
  require(options.tf_timeout_s >= 0.0,
          "tf_timeout_s: " + std::to_string(options.tf_timeout_s) + " s is negative");
  require(options.threads >= 1 && options.threads <= kMostThreads,
          "threads: " + std::to_string(options.threads) + " is not in [1, 256]");
  for (const std::string& problem : problems(options.layout)) all.push_back("layout." + problem);
  const std::vector<std::string> camera = cameraProblems(options.camera);
  all.insert(all.end(), camera.begin(), camera.end());
  if (!camera.empty()) return all;
  simulation::Scene scene;
  scene.floor = options.floor;
  scene.marker = options.marker;
  scene.noise = options.noise;
  scene.camera = sceneCamera(options.camera);
  for (const std::string& problem : problems(scene)) all.push_back(problem);
  return all;
}

CellSimulatorOptions readCellSimulatorOptions(const YAML::Node& tree) {
  CellSimulatorOptions options;
  adapters::OptionReader reader(tree);
  readCellOrderOptions(reader, options.order);
  reader.read("n_pick", options.n_pick);
  reader.read("frame_id", options.frame_id);
  reader.read("cloud_layout", options.cloud_layout);
  reader.read("base_frame", options.base_frame);
  reader.read("take_tolerance_m", options.take_tolerance_m);
  reader.read("tf_timeout_s", options.tf_timeout_s);
  reader.read("threads", options.threads);
  readCamera(reader.section("camera"), options.camera);
  readScene(reader, options);
  readLayout(reader.section("layout"), options.layout);
  reader.add(problems(options));
  reader.finish("parameters of the simulated cell");
  return options;
}

simulation::Scene cellScene(const CellSimulatorOptions& options) {
  std::string text;
  for (const std::string& problem : problems(options)) text += (text.empty() ? "" : "; ") + problem;
  if (!text.empty()) throw std::invalid_argument("cellScene: options: " + text);
  simulation::Scene scene;
  scene.floor = options.floor;
  scene.marker = options.marker;
  scene.camera = sceneCamera(options.camera);
  scene.noise = options.noise;
  return scene;
}

}  // namespace mixed_palletizing::cell
