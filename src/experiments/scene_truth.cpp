#include <algorithm>
#include <cmath>
#include <utility>

#include <mixed_palletizing/experiments/scene_truth.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>

namespace mixed_palletizing::experiments {
namespace {

/// A point this near to the height of the top belongs to it and not to a side face [m].
constexpr double kTopBand = 0.02;

bool isInside(const Eigen::Vector2d& pixel, const simulation::Camera& camera) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= camera.width_px - 1.0 &&
         pixel.y() <= camera.height_px - 1.0;
}

TrueBox nominal(const simulation::SceneBox& box, const geometry::Pose& base_from_world) {
  TrueBox truth;
  truth.size = box.size_m;
  truth.size.z() += simulation::topOffsets(box).mean_m;
  const Eigen::Vector3d top(box.position_m.x(), box.position_m.y(), box.base_z_m + truth.size.z());
  truth.top_center = base_from_world * top;
  truth.yaw_rad = box.yaw_rad + geometry::yawOf(base_from_world);
  if (truth.size.x() < truth.size.y()) {
    std::swap(truth.size.x(), truth.size.y());
    truth.yaw_rad += M_PI / 2;
  }
  truth.yaw_rad = geometry::foldHalfTurn(truth.yaw_rad);
  return truth;
}

/// Points with data on the top of every box.
std::vector<std::size_t> measuredTopPixels(const simulation::Scene& scene,
                                           const simulation::Capture& capture) {
  std::vector<std::size_t> counts(scene.boxes.size(), 0);
  const geometry::Pose& world_from_camera = scene.camera.world_from_camera;
  for (std::size_t i = 0; i < capture.mask.size(); ++i) {
    const geometry::ColoredPoint& p = capture.cloud.points[i];
    if (capture.mask[i] == 0 || capture.mask[i] > counts.size() || !std::isfinite(p.z)) continue;
    const std::size_t box = capture.mask[i] - 1u;
    const Eigen::Vector3d world = world_from_camera * Eigen::Vector3f(p.x, p.y, p.z).cast<double>();
    const double top = scene.boxes[box].base_z_m + scene.boxes[box].size_m.z();
    if (std::abs(world.z() - top) <= kTopBand) ++counts[box];
  }
  return counts;
}

/// Pixels that the convex outline covers in an unlimited image.
double outlinePixels(const std::array<Eigen::Vector2d, 4>& corners) {
  double twice = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % 4];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

bool TrueBox::counts() const {
  return !truncated && visible_ratio >= kLeastVisible && measured_ratio >= kLeastMeasured;
}

geometry::Pose trueBaseFromCamera(const simulation::Scene& scene) {
  if (!scene.has_marker) return scene.camera.world_from_camera;
  return simulation::worldFromMarker(scene.marker).inverse() * scene.camera.world_from_camera;
}

Eigen::Vector2d projectedPoint(const simulation::Scene& scene, const geometry::Pose& base_from_camera,
                               const Eigen::Vector3d& point) {
  return simulation::Pinhole(scene.camera).project(base_from_camera.inverse() * point);
}

std::array<Eigen::Vector2d, 4> projectedCorners(const simulation::Scene& scene,
                                                const geometry::Pose& base_from_camera,
                                                const geometry::Rectangle& rectangle, double height_m) {
  const std::array<Eigen::Vector2d, 4> corners = rectangle.corners();
  std::array<Eigen::Vector2d, 4> pixels;
  for (std::size_t i = 0; i < 4; ++i) {
    pixels[i] = projectedPoint(scene, base_from_camera, {corners[i].x(), corners[i].y(), height_m});
  }
  return pixels;
}

std::vector<TrueBox> trueBoxes(const simulation::Scene& scene, const simulation::Capture& capture) {
  const geometry::Pose base_from_camera = trueBaseFromCamera(scene);
  const geometry::Pose base_from_world = base_from_camera * scene.camera.world_from_camera.inverse();
  const std::vector<std::size_t> measured = measuredTopPixels(scene, capture);
  std::vector<TrueBox> boxes;
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    TrueBox truth = nominal(scene.boxes[i], base_from_world);
    truth.corners_px = projectedCorners(scene, base_from_camera, truth.footprint(), truth.top_center.z());
    truth.truncated = !std::all_of(truth.corners_px.begin(), truth.corners_px.end(),
                                   [&](const Eigen::Vector2d& c) { return isInside(c, scene.camera); });
    truth.visible_ratio = capture.top_visibility.at(i);
    const double alone = std::max(1.0, outlinePixels(truth.corners_px));
    truth.measured_ratio = std::min(1.0, static_cast<double>(measured[i]) / alone);
    boxes.push_back(truth);
  }
  return boxes;
}

}  // namespace mixed_palletizing::experiments
