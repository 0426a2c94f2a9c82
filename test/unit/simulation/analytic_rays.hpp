// Rays against boxes and floor in plain arithmetic: what the ray caster must agree with.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <mixed_palletizing/simulation/pinhole.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation::analytic {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Hit {
  double t = kInfinity;  // point = eye + t * direction
  int object = -1;       // 0 = floor, i + 1 = box i
};

/// Range of t within which eye + t * direction lies in the box; empty when low > high.
struct Range {
  double low;
  double high;
};

inline Range within(const SceneBox& box, const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) {
  const geometry::Pose box_from_world = worldFromBox(box).inverse();
  const Eigen::Vector3d start = box_from_world * eye;
  const Eigen::Vector3d path = box_from_world.linear() * direction;
  Range range{-kInfinity, kInfinity};
  for (int axis = 0; axis < 3; ++axis) {
    const double one = (-0.5 * box.size_m[axis] - start[axis]) / path[axis];
    const double two = (0.5 * box.size_m[axis] - start[axis]) / path[axis];
    range.low = std::max(range.low, std::min(one, two));
    range.high = std::min(range.high, std::max(one, two));
  }
  return range;
}

inline Hit trace(const Scene& scene, const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) {
  Hit best;
  const double floor = -eye.z() / direction.z();
  const Eigen::Vector3d point = eye + floor * direction;
  if (floor > 0.0 && std::abs(point.x()) <= 0.5 * scene.floor.size_x_m &&
      std::abs(point.y()) <= 0.5 * scene.floor.size_y_m) {
    best = {floor, 0};
  }
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    const Range range = within(scene.boxes[i], eye, direction);
    if (range.low < range.high && range.low > 0.0 && range.low < best.t) {
      best = {range.low, static_cast<int>(i + 1)};
    }
  }
  return best;
}

/// What the centre of a pixel sees; t is the depth.
inline Hit tracePixel(const Scene& scene, int row, int col) {
  const geometry::Pose& pose = scene.camera.world_from_camera;
  return trace(scene, pose.translation(), pose.linear() * Pinhole(scene.camera).ray(col, row));
}

/// Whether a box stands between two points; one that only touches the first does not.
inline bool blocked(const Scene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  for (const SceneBox& box : scene.boxes) {
    const Range range = within(box, from, to - from);
    if (std::max(range.low, 1e-4) < std::min(range.high, 1.0)) return true;
  }
  return false;
}

}  // namespace mixed_palletizing::simulation::analytic
