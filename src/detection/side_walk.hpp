// One side of a part of a level surface: where the part ends there.
#pragma once

#include <optional>
#include <utility>

#include "top_split.hpp"

namespace mixed_palletizing::detection {

/// How far outside of a part's line its end is looked for.
constexpr double kReachOut_m = 0.014;

/// True for the sides of a part that run along v.
inline bool isUpright(std::size_t side) { return side % 2 == 1; }

/// Walks a picture across one side of a part. The end is a clear edge of brightness around the line, else the middle of
/// a seam, else the end of the surface. Distances across are counted outwards from the side's line, in cells.
class SideWalk {
 public:
  /// The side from `begin` to `end` along it. The picture must outlive the walk.
  SideWalk(const TopPicture& picture, const TopPart& part, std::size_t side, double begin, double end);

  /// The part's line, across.
  double nominal(double along) const { return line_.offset + line_.slope * along; }

  /// Where the part ends at `along`, and what is seen behind.
  std::optional<double> endAt(double along, TopCell& behind) const;

 private:
  /// A line along which the brightness steps.
  struct Edge {
    double out = 0.0;    // at the middle of the side
    double slope = 0.0;  // outwards
    double rise = 0.0;   // mean over its length, signed
  };

  double middle() const { return 0.5 * (begin_ + end_); }
  std::pair<int, int> cellAt(double along, double across) const;
  bool isTop(double along, double across) const;
  TopCell kindAt(double along, double across) const;
  TopCell kindBehind(double along, double end) const;
  float grayAt(double along, double across) const;
  float stepAt(double along, double out) const;
  Edge clearest(double out) const;
  void findEdge();
  std::optional<double> stepNear(double along, double out) const;
  std::optional<double> seamAt(double along) const;
  std::optional<double> surfaceEnd(double along) const;

  const TopPicture& picture_;
  const PartSide line_;
  const bool upright_;
  const double out_;
  const double begin_;
  const double end_;
  std::optional<Edge> edge_;
};

}  // namespace mixed_palletizing::detection
