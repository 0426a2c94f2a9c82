// A level surface as seen along straight lines: what seams are looked for in.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rectangle_cover.hpp"

namespace mixed_palletizing::detection {

/// Places side by side across an axis ("across"), in lines one behind the other. Keeps its memory between calls.
class SeamLattice {
 public:
  /// Looks at every place of the group's level within the bounds. `axis`: 0 for places along u, 1 along v.
  void look(const BaseCloud& cloud, const LevelPieces& pieces, const TopGroup& group, const TopAxes& axes,
            const LocalBox& bounds, int axis);

  int count() const { return count_; }  ///< places across
  int lines() const { return lines_; }
  double step() const { return step_m_; }           ///< between places across [m]
  double lineStep() const { return line_step_m_; }  ///< between lines [m]

  /// Coordinate of a place across (whole numbers: the places).
  double across(double i) const { return from_m_ + (i + 0.5) * step_m_; }
  /// Number of the line at a coordinate along, not rounded.
  double lineAt(double along_m) const { return (along_m - line_from_m_) / line_step_m_; }

  /// Whether the surface is there; false beyond the lattice.
  bool top(int line, int i) const {
    return line >= 0 && line < lines_ && i >= 0 && i < count_ && tops(line)[i] != 0;
  }

  /// Of the places of a line: 1 where the surface is.
  const std::uint8_t* tops(int line) const { return tops_.data() + start(line); }
  /// Heights above the surface, held within what a seam may be [m].
  const float* heights(int line) const { return heights_.data() + start(line); }
  /// One of three channels of colour; 0 where the surface is not.
  const std::uint8_t* colors(int line, std::size_t channel) const {
    return colors_[channel].data() + start(line);
  }

  /// Spread of the colour between places that are the same but for noise.
  double colorNoise() const;

 private:
  void prefetch(const geometry::CloudView& view, int i) const;
  std::size_t start(int line) const {
    return static_cast<std::size_t>(line) * static_cast<std::size_t>(count_);
  }

  int count_ = 0;
  int lines_ = 0;
  double step_m_ = 0.0;
  double line_step_m_ = 0.0;
  double from_m_ = 0.0;
  double line_from_m_ = 0.0;
  std::vector<std::uint8_t> tops_;
  std::vector<float> heights_;
  std::array<std::vector<std::uint8_t>, 3> colors_;
  std::array<std::vector<float>, 2> places_;  // of one line, in the axes of the top
  std::vector<int> cols_;                     // of the pixels that see them
  std::vector<int> rows_;
};

}  // namespace mixed_palletizing::detection
