// What the camera saw of the level of a top, place by place: the top itself, something else, or nothing.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "outline_lines.hpp"

namespace mixed_palletizing::detection {

/// Dents are smaller than this share of their top's largest piece, and at most so deep [m].
constexpr double kDentShare = 0.3;
constexpr double kDeepestDent = 0.016;

/// Rectangle in a top's axes [m].
struct LocalBox {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();
  Eigen::Vector2d size() const { return high - low; }
  double area() const { return size().prod(); }
  bool contains(const Eigen::Vector2d& p) const {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
  void include(const Eigen::Vector2d& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  static LocalBox none() {
    return {Eigen::Vector2d::Constant(INFINITY), Eigen::Vector2d::Constant(-INFINITY)};
  }
};

enum class Seen : std::uint8_t {
  kTop,      ///< the surface is there
  kFree,     ///< the camera looks past: no surface there
  kUnknown,  ///< hidden by something nearer, outside of the image, or without data
};

/// Pieces that may be parts of the same tops.
struct TopGroup {
  std::vector<int> pieces;
  std::vector<int> dents;  ///< pieces that lie in dents of these
  std::vector<EdgeSample> samples;
  RayModel rays;
  PixelBox box;
  WalkScale scale;     ///< of the largest piece
  int largest = 0;     ///< piece
  double pixel_m = 0;  ///< length of a pixel on the top
  double yaw_rad = 0;  ///< of the samples, see sharpestYaw()
};

/// Map from a top's axes to the pixels that see its level.
LevelMap mapOf(const LevelPiece& level, const RayModel& rays, const TopAxes& axes);

class TopRaster {
 public:
  /// Looks at every place of the group's surroundings; keeps its memory.
  void fill(const BaseCloud& cloud, const CellGrid& cells, const LevelPieces& pieces, const TopGroup& group,
            const TopAxes& axes);

  double pitch() const { return pitch_m_; }
  const LocalBox& bounds() const { return bounds_; }

  struct Count {
    int all = 0;
    int top = 0;
    int free = 0;
    int unknown() const { return all - top - free; }
  };
  /// Places inside a rectangle.
  Count count(const LocalBox& box) const;

 private:
  Seen look(const BaseCloud& cloud, const CellGrid& cells, const LevelPieces& pieces, const TopGroup& group,
            int row, int col, double level) const;
  std::size_t at(int i, int k) const {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(cols_ + 1) + static_cast<std::size_t>(i);
  }

  double pitch_m_ = 0.0;
  LocalBox bounds_;
  int cols_ = 0;
  int rows_ = 0;
  std::vector<int> top_;  // sums over all places with smaller indices
  std::vector<int> free_;
  std::vector<char> member_;  // whether a piece belongs to the group
};

}  // namespace mixed_palletizing::detection
