// Seams across a level surface: where two boxes of one height touch.
//
// Along a seam the surface dips or has no data, or the colour changes. A seam is straight, parallel to the axes of
// the outline, and runs all the way from one line of the outline to another; prints and labels seldom do.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rectangle_cover.hpp"

namespace mixed_palletizing::detection {

/// Keeps its memory between calls.
class SeamSearch {
 public:
  /// Seams of a group's surface, in its axes.
  const std::vector<Seam>& find(const BaseCloud& cloud, const LevelPieces& pieces, const TopGroup& group,
                                const TopAxes& axes, const OutlineLines& lines, const LocalBox& bounds);

 private:
  /// What is seen at one place of the lattice.
  struct Spot {
    float off = 0.0f;  ///< height above the surface, held within what a seam may be [m]
    std::array<std::int16_t, 3> color{};
    bool top = false;  ///< the surface is there
  };
  void sample(const BaseCloud& cloud, const LevelPieces& pieces, const TopGroup& group, const TopAxes& axes,
              const LocalBox& bounds, int axis);
  void findAcross(int axis, double noise_m, double least_dip, const std::vector<double>& breaks);
  bool wide(int line, int i) const;
  bool endsAt(double along_m, int sign, int i, int axis) const;
  void rate(int line, double color_step);
  const Spot& spot(int line, int i) const {
    return spots_[static_cast<std::size_t>(line) * static_cast<std::size_t>(count_) +
                  static_cast<std::size_t>(i)];
  }
  double colorNoise() const;

  int count_ = 0;  // places across
  int lines_ = 0;  // lines along
  double step_m_ = 0.0;
  double line_step_m_ = 0.0;
  double from_m_ = 0.0;
  double line_from_m_ = 0.0;
  std::vector<Spot> spots_;
  std::vector<float> dips_;           // of each spot: depth below its two sides [m]
  std::vector<std::uint8_t> inside_;  // of each spot: the surface is on both sides
  std::vector<std::uint8_t> steps_;   // of each spot: the colour changes there
  std::vector<Seam> seams_;
};

}  // namespace mixed_palletizing::detection
