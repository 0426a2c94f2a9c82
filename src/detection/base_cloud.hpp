// An organized cloud seen from the base frame: points and viewing rays, computed where they are needed.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {

/// The view must outlive this object. Single precision is enough: it resolves 0.2 um at 2 m.
class BaseCloud {
 public:
  BaseCloud(const geometry::CloudView& view, const geometry::Pose& base_from_camera)
      : view_(view),
        rotation_(base_from_camera.linear().cast<float>()),
        camera_(base_from_camera.translation().cast<float>()) {}

  const geometry::CloudView& view() const { return view_; }
  int width() const { return view_.width; }
  int height() const { return view_.height; }

  /// Position of the camera in the base frame [m].
  Eigen::Vector3d camera() const { return camera_.cast<double>(); }

  /// Third row of base_from_camera: height above the floor = row . p_camera + camera().z().
  Eigen::Vector3f upInCamera() const { return rotation_.row(2); }

  const Eigen::Matrix3f& rotation() const { return rotation_; }

  /// A point of the camera frame in the base frame [m].
  Eigen::Vector3f toBase(const Eigen::Vector3f& point) const { return rotation_ * point + camera_; }

  /// Point in the base frame [m]; not finite where the camera has no data.
  Eigen::Vector3f point(int row, int col) const { return toBase(view_.point(row, col)); }

  /// True when the camera measured something in front of it here.
  bool valid(int row, int col) const {
    const Eigen::Vector3f p = view_.point(row, col);
    return p.z() > 0.0f && std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  }

  /// Viewing ray of a valid pixel in the base frame, scaled to depth 1. Noise along the ray drops out.
  Eigen::Vector3d ray(int row, int col) const {
    const Eigen::Vector3f p = view_.point(row, col);
    return (rotation_ * (p / p.z())).cast<double>();
  }

 private:
  const geometry::CloudView& view_;
  Eigen::Matrix3f rotation_;
  Eigen::Vector3f camera_;
};

}  // namespace mixed_palletizing::detection
