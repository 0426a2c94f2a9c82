// Random scenes of separated boxes in front of a camera, for tests and experiments.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

struct RandomSceneOptions {
  int boxes_min = 1;
  int boxes_max = 5;
  Eigen::Vector3d box_size_min_m = Eigen::Vector3d(0.12, 0.10, 0.06);
  Eigen::Vector3d box_size_max_m = Eigen::Vector3d(0.30, 0.22, 0.25);
  double gap_m = 0.04;          ///< least distance between footprints, and to the marker's paper
  double distance_min_m = 1.3;  ///< from the camera to the point on the floor it looks at
  double distance_max_m = 1.7;
  double tilt_min_rad = 0.0;  ///< of the optical axis against straight down
  double tilt_max_rad = 0.7;
  double target_offset_max_m = 0.15;  ///< from the marker's centre to the point it looks at
  double border_px_ratio = 0.01;      ///< boxes and marker keep this share of the width from the border
  double min_top_visibility = 0.0;    ///< every box shows at least this share of its top
  bool marker_in_sight = true;        ///< no box stands before the marker
  Scene scene;                        ///< everything else: floor, marker, resolution, field of view, noise
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const RandomSceneOptions& options);

/// Scene with a random camera that looks at the marker (without one: at the origin) and boxes of random size,
/// place, yaw and colour, all of them within the image. The same options and seed give the same scene.
/// Throws std::invalid_argument with every line of problems(options), std::runtime_error when no such scene
/// was found (boxes too many or too large for the view).
Scene randomScene(const RandomSceneOptions& options, std::uint64_t seed);

}  // namespace mixed_palletizing::simulation
