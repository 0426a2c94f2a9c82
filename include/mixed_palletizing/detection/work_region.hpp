// The part of the base frame in which boxes are looked for.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/plane.hpp>
#include <mixed_palletizing/geometry/polygon.hpp>

namespace mixed_palletizing::detection {

/// Everything else is ignored as if it had no data. Base frame, z up.
struct RegionOptions {
  std::vector<double>
      polygon_m;  ///< x, y of the corners, one after the other, in either sense; empty: everywhere
  double min_z_m = -1.0;
  double max_z_m = 20.0;
  std::vector<geometry::Plane> planes;  ///< things that are no boxes: tables, conveyors, walls
  double plane_distance_m = 0.010;      ///< points this near to one of them are ignored
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const RegionOptions& options);

/// Answers for single points; cheap to copy.
class WorkRegion {
 public:
  WorkRegion() = default;

  /// Throws std::invalid_argument with every line of problems(options).
  explicit WorkRegion(const RegionOptions& options);

  /// False when every point lies inside, so that nobody needs to ask.
  bool limited() const { return limited_; }

  /// True for a point of the base frame [m] that may belong to a box.
  bool contains(const Eigen::Vector3f& point) const;

 private:
  bool limited_ = false;
  float min_z_m_ = -std::numeric_limits<float>::infinity();
  float max_z_m_ = std::numeric_limits<float>::infinity();
  float plane_distance_m_ = 0.0f;
  std::vector<Eigen::Vector2f> polygon_;
  std::vector<Eigen::Vector4f> planes_;  // normal and offset
};

}  // namespace mixed_palletizing::detection
