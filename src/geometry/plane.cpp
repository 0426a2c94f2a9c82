#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Eigenvalues>

#include <mixed_palletizing/geometry/plane.hpp>

namespace mixed_palletizing::geometry {

Plane Plane::facing(const Eigen::Vector3d& point) const {
  return signedDistance(point) < 0.0 ? Plane{-normal, -offset} : *this;
}

void PlaneAccumulator::add(const Eigen::Vector3d& point) {
  if (count_ == 0) shift_ = point;
  const Eigen::Vector3d p = point - shift_;
  ++count_;
  sum_ += p;
  squares_ += p * p.transpose();
}

PlaneAccumulator::Fit PlaneAccumulator::fit() const {
  if (count_ < 3) {
    throw std::invalid_argument("PlaneAccumulator::fit: " + std::to_string(count_) +
                                " points, at least 3 needed");
  }
  const double n = static_cast<double>(count_);
  const Eigen::Vector3d mean = sum_ / n;
  const Eigen::Matrix3d covariance = squares_ / n - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d values = solver.eigenvalues();  // ascending
  if (!(values(1) > 1e-12 * std::max(values(2), 1e-300))) {
    throw std::invalid_argument("PlaneAccumulator::fit: all points lie on one line");
  }
  Fit fit;
  fit.centroid = mean + shift_;
  fit.plane.normal = solver.eigenvectors().col(0);
  fit.plane.offset = -fit.plane.normal.dot(fit.centroid);
  fit.rms_m = std::sqrt(std::max(values(0), 0.0));
  return fit;
}

}  // namespace mixed_palletizing::geometry
