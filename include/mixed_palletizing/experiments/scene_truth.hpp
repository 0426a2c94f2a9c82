// What a detector should find in a simulated scene.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/pose.hpp>
#include <mixed_palletizing/geometry/rectangle.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::experiments {

/// A box of the scene in the base frame. Lengths in metres, angles in radians.
struct TrueBox {
  Eigen::Vector3d top_center = Eigen::Vector3d::Zero();  ///< at the mean height of the top
  Eigen::Vector3d size = Eigen::Vector3d::Zero();        ///< length >= width, height of the mean top
  double yaw_rad = 0.0;                                  ///< of the length axis
  double visible_ratio = 0.0;   ///< of the top: its pixels in the image over those it would have alone
  double measured_ratio = 0.0;  ///< the same for its pixels that carry data
  bool truncated = false;       ///< a corner of the top lies outside the image
  std::array<Eigen::Vector2d, 4> corners_px{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
                                            Eigen::Vector2d::Zero(),
                                            Eigen::Vector2d::Zero()};  ///< of the top, column and row

  geometry::Rectangle footprint() const { return {top_center.head<2>(), yaw_rad, size.head<2>()}; }

  /// Whether a detector must find it: the whole top is within the image, at least kLeastVisible of it is
  /// seen, and at least kLeastMeasured carries data. A box that need not be found is neither missed nor
  /// invented.
  bool counts() const;
};

/// The hardest tops of the hidden recipes show 40 %; a third leaves room for what the projector does not
/// light.
constexpr double kLeastVisible = 0.35;
constexpr double kLeastMeasured = 0.25;

/// The base frame: the marker's; without a marker the world's.
geometry::Pose trueBaseFromCamera(const simulation::Scene& scene);

/// One for every box of the scene. `capture` is one of this scene.
std::vector<TrueBox> trueBoxes(const simulation::Scene& scene, const simulation::Capture& capture);

/// A point of the base frame as the scene's camera sees it (column, row).
Eigen::Vector2d projectedPoint(const simulation::Scene& scene, const geometry::Pose& base_from_camera,
                               const Eigen::Vector3d& point);

/// Corners of a level rectangle at `height_m` of the base frame as the scene's camera sees them (column,
/// row).
std::array<Eigen::Vector2d, 4> projectedCorners(const simulation::Scene& scene,
                                                const geometry::Pose& base_from_camera,
                                                const geometry::Rectangle& rectangle, double height_m);

}  // namespace mixed_palletizing::experiments
