// Outline of a top face in the grid: where rows and columns enter and leave it, and what lies across.
//
// A side of the box ends between the last pixel on the top and the next one, so each sample lies on the ray
// half a pixel outside of the last pixel. Rays are met with planes of a known height: noise along the ray
// does not move the sample.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "base_cloud.hpp"
#include "grid_runs.hpp"
#include "top_plane.hpp"

namespace mixed_palletizing::detection {

/// What is seen just outside of the outline.
enum class Across {
  kFree,      ///< something lower or farther: a side of the top
  kOccluder,  ///< something higher and in front: the top goes on behind it
  kBorder,    ///< nothing up to the border of the image, which is near
};

struct OutlineSample {
  Eigen::Vector2d measured = Eigen::Vector2d::Zero();  ///< the last point, seen from above (base frame) [m]
  Eigen::Vector2d at_top = Eigen::Vector2d::Zero();    ///< the border ray at the height of the top [m]
  Eigen::Vector2d at_band =
      Eigen::Vector2d::Zero();  ///< the border ray at the lower end of the top band: where a side face begins
  double pixel_m = 0.0;         ///< length of one pixel across the border, on the top
  int row = 0;
  int col = 0;
  bool along_row = true;  ///< found along a row (else along a column)
  bool goes_on = false;   ///< the very next pixel across has data: the surface may bend down there
  Across across = Across::kFree;
};

/// Finds the samples of one top; keeps its memory between calls.
class OutlineTracer {
 public:
  /// First and last point of every row and of every column of the top. `step_m`: something across that is
  /// higher by this and farther away from the sample than this is an occluder.
  void trace(const BaseCloud& cloud, const RunRange& top, double height_m, const TopBand& band, double step_m,
             std::vector<OutlineSample>& samples);

 private:
  struct Span {
    int first = -1;
    int last = -1;
  };
  std::vector<Span> columns_;  // first and last row of each column
};

}  // namespace mixed_palletizing::detection
