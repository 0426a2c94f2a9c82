// Planes in 3D and their least-squares fit.
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace mixed_palletizing::geometry {

/// Points p with normal . p + offset = 0; the normal has length 1 and the offset is in metres.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0.0;

  /// Distance [m] of a point, positive on the side the normal points to.
  double signedDistance(const Eigen::Vector3d& point) const { return normal.dot(point) + offset; }

  /// The same plane with the normal pointing to the side of `point`.
  Plane facing(const Eigen::Vector3d& point) const;
};

/// Running sums of points for a plane fit in one pass: O(1) memory, points may be added in any order.
class PlaneAccumulator {
 public:
  void add(const Eigen::Vector3d& point);
  std::size_t count() const { return count_; }

  struct Fit {
    Plane plane;
    double rms_m = 0.0;  ///< root mean square distance of the points to the plane
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  };

  /// Total least squares plane. Throws std::invalid_argument for fewer than 3 points or points on one line.
  Fit fit() const;

 private:
  std::size_t count_ = 0;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();  // the first point: keeps the sums small
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
};

}  // namespace mixed_palletizing::geometry
