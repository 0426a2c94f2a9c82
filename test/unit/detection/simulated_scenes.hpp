// Scenes for the tests of the detection, with the boxes that should be found.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/geometry/pose.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace mixed_palletizing::test {

inline simulation::Recipe sceneRecipe(double noise_at_1m_m, int width_px, int height_px) {
  simulation::Recipe recipe;
  recipe.scene.camera.width_px = width_px;
  recipe.scene.camera.height_px = height_px;
  recipe.scene.noise.depth_stddev_at_1m_m = noise_at_1m_m;
  recipe.scene.noise.no_data_on_black = true;
  return recipe;
}

inline geometry::Pose trueBaseFromCamera(const simulation::Scene& scene) {
  return simulation::worldFromMarker(scene.marker).inverse() * scene.camera.world_from_camera;
}

/// A box of the scene in the base frame.
struct TrueBox {
  Eigen::Vector3d top_center = Eigen::Vector3d::Zero();
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< length >= width
  double yaw_rad = 0.0;
};

inline std::vector<TrueBox> trueBoxes(const simulation::Scene& scene) {
  const geometry::Pose base_from_world = simulation::worldFromMarker(scene.marker).inverse();
  std::vector<TrueBox> boxes;
  for (const simulation::SceneBox& box : scene.boxes) {
    TrueBox truth;
    truth.top_center = base_from_world *
                       Eigen::Vector3d(box.position_m.x(), box.position_m.y(), box.base_z_m + box.size_m.z());
    truth.size = box.size_m;
    truth.yaw_rad = box.yaw_rad + geometry::yawOf(base_from_world);
    if (truth.size.x() < truth.size.y()) {
      std::swap(truth.size.x(), truth.size.y());
      truth.yaw_rad += M_PI / 2;
    }
    boxes.push_back(truth);
  }
  return boxes;
}

/// The found box nearest to a true one; null when none is within `reach_m`.
inline const detection::DetectedBox* nearest(const detection::Detections& detections, const TrueBox& truth,
                                             double reach_m = 0.03) {
  const detection::DetectedBox* best = nullptr;
  for (const detection::DetectedBox& box : detections.boxes) {
    const double distance = (box.top_center - truth.top_center).norm();
    if (distance < reach_m) {
      reach_m = distance;
      best = &box;
    }
  }
  return best;
}

/// Angle between the length axes; for squares the axes may be swapped.
inline double yawError(const detection::DetectedBox& box, const TrueBox& truth) {
  const double error = geometry::foldHalfTurn(box.yaw_rad - truth.yaw_rad);
  const bool square = truth.size.x() - truth.size.y() < 0.005;
  return std::abs(square ? geometry::foldQuarterTurn(error) : error);
}

}  // namespace mixed_palletizing::test
