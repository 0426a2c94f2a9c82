// The straight lines that an outline is made of: its direction, and where its sides lie across it.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "edge_walks.hpp"

namespace mixed_palletizing::detection {

/// Axes of a top in the base frame: u along the yaw, v to its left. Angles of sides fold to a quarter turn.
struct TopAxes {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  Eigen::Vector2d u = Eigen::Vector2d::UnitX();
  Eigen::Vector2d v = Eigen::Vector2d::UnitY();

  TopAxes() = default;
  TopAxes(const Eigen::Vector2d& at, double yaw);
  Eigen::Vector2d local(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d d = place - origin;
    return {d.dot(u), d.dot(v)};
  }
  Eigen::Vector2d place(const Eigen::Vector2d& local) const { return origin + local.x() * u + local.y() * v; }
};

/// A line across an axis.
struct OutlineLine {
  double at_m = 0.0;
  double length_m = 0.0;  ///< of the outline on it
  bool low = false;       ///< surface ends here on its low side, on its high side, or both (a cut)
  bool high = false;
};

/// Lines by the axis they cross: [0] across u, [1] across v; sorted by place.
using OutlineLines = std::array<std::vector<OutlineLine>, 2>;

/// Memory of the two functions below, kept between calls.
struct LineBuffers {
  /// Samples of one axis and sign, in local coordinates.
  struct SideSample {
    double across = 0.0;
    double along = 0.0;
    double length = 0.0;
  };
  /// Places across one direction.
  struct Profile {
    std::vector<double> at;  ///< of each place, in bins from the first
    std::vector<double> counts;
  };
  std::vector<double> x, y;  ///< of places
  std::array<Profile, 2> profiles;
  std::array<std::vector<SideSample>, 4> sides;
  std::vector<double> bins;
};

/// Yaw [rad] in [0, pi/2) that makes the samples fall onto the fewest lines.
/// Source: the sharpness of projection profiles, as in skew estimation of scanned pages.
double sharpestYaw(const std::vector<EdgeSample>& samples, double pixel_m, LineBuffers& buffers);

/// Finds the lines of at least `min_length_m`, and turns the axes onto them by least squares.
void findLines(const std::vector<EdgeSample>& samples, double pixel_m, double min_length_m, TopAxes& axes,
               LineBuffers& buffers, OutlineLines& lines);

}  // namespace mixed_palletizing::detection
