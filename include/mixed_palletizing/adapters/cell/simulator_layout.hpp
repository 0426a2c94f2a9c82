// Where boxes can stand in front of the simulated camera.
#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include <mixed_palletizing/geometry/rectangle.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::cell {

struct CellLayoutOptions {
  double gap_m = 0.06;      ///< least distance between boxes, and between a box and the marker's paper
  double border_px = 30.0;  ///< boxes keep this distance from the border of the image
  int tries = 2000;         ///< random places tried for one box
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const CellLayoutOptions& options);

/// Places boxes on the floor of a scene at random, so that each is wholly in the image, keeps its distance, and
/// hides neither the top of another nor the marker. World frame of the scene [m].
class CellLayout {
 public:
  /// Camera and marker of `scene` count, its boxes do not. Throws std::invalid_argument with every line of
  /// problems(options), when the image reaches the horizon, or when the marker is not in the image.
  CellLayout(const simulation::Scene& scene, const CellLayoutOptions& options);

  /// Whether a box can stand where it is among the others.
  bool allows(const simulation::SceneBox& box, const std::vector<simulation::SceneBox>& others) const;

  /// Gives `box` a random place and yaw among the others; false, and the box as it was, when none was found.
  bool place(simulation::SceneBox& box, const std::vector<simulation::SceneBox>& others,
             std::mt19937_64& random) const;

 private:
  bool inImage(const Eigen::Vector3d& point_world) const;
  bool inImage(const simulation::SceneBox& box) const;
  bool hides(const simulation::SceneBox& blocker, const geometry::Rectangle& target, double target_z) const;
  Eigen::Vector2d onFloor(double u, double v) const;

  CellLayoutOptions options_;
  simulation::Camera camera_;
  std::optional<geometry::Rectangle> paper_;  // the marker with its quiet zone
  Eigen::Vector2d view_min_;                  // bounds of the floor in the image
  Eigen::Vector2d view_max_;
};

}  // namespace mixed_palletizing::cell
