// Private parameters of the simulated cell.
#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include <mixed_palletizing/adapters/cell/order.hpp>
#include <mixed_palletizing/adapters/cell/simulator_layout.hpp>
#include <mixed_palletizing/adapters/names.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::cell {

/// Where the camera hangs. The marker's centre is the origin of the floor, x along its edge.
struct CellCameraOptions {
  double distance_m = 2.4;           ///< to the point it looks at
  double tilt_deg = 20.0;            ///< of its axis against straight down, towards the marker's +y
  double horizontal_fov_deg = 56.0;  ///< as Zivid 2; at 2.4 m it covers 2.5 m x 1.6 m
  int width_px = 1920;
  int height_px = 1200;
  std::vector<double> target_m{1.0, 0.5};  ///< point of the floor it looks at
};

struct CellSimulatorOptions {
  CellOrderOptions order;
  int n_pick = 0;                                        ///< boxes in the pick area; 0 = the order's
  std::string frame_id = adapters::names::kCameraFrame;  ///< of the clouds
  std::string cloud_layout =
      "xyzrgba_float32";  ///< of points/xyzrgba: one of adapters::cloudLayoutNames() with colour
  std::string base_frame = adapters::names::kBaseFrame;  ///< of the topic `truth`: the marker's
  CellCameraOptions camera;
  simulation::Floor floor;
  simulation::Marker marker;
  simulation::Noise noise;
  CellLayoutOptions layout;
  double take_tolerance_m = 0.05;  ///< how far from a box the point of take_box may lie
  double tf_timeout_s = 2.0;       ///< how long take_box waits for the transform
  int threads = 2;                 ///< of the ray casting

  /// Noise of a structured-light camera: 0.2 mm at 1 m, nothing seen on black ink.
  CellSimulatorOptions();
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const CellSimulatorOptions& options);

/// Reads a tree of parameters. Throws std::invalid_argument with everything that is wrong: unknown keys, wrong
/// types, broken rules.
CellSimulatorOptions readCellSimulatorOptions(const YAML::Node& tree);

/// The scene without boxes. Throws std::invalid_argument with every line of problems(options).
simulation::Scene cellScene(const CellSimulatorOptions& options);

}  // namespace mixed_palletizing::cell
