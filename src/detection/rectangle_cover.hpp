// The fewest rectangles that explain a group of level pieces: what one box, or several that touch, look like
// from above.
//
// Every side of every rectangle lies on a line of the outline (or on a seam, or where the visible surface ends).
// A rectangle may hold surface and unknown places, not places that the camera looked past. Among the sets of
// disjoint rectangles the one with the best account of sides and surface is taken.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "top_raster.hpp"

namespace mixed_palletizing::detection {

/// A line across the surface where two boxes meet.
struct Seam {
  int axis = 0;  ///< across u (0) or v (1)
  double at_m = 0.0;
  double from_m = 0.0;  ///< along the other axis
  double to_m = 0.0;
};

struct CoverOptions {
  double min_side_m = 0.02;
  double max_side_m = 1.5;
};

/// A rectangle of the cover.
struct CoverBox {
  LocalBox box;
  std::array<double, 4> support{};  ///< share of each side with outline on it: low u, high u, low v, high v
  std::array<double, 4> cut{};      ///< share of each side that runs through the surface
  double score = 0.0;
};

/// Keeps its memory between calls.
class RectangleCover {
 public:
  /// Rectangles, best first; empty when none explains anything.
  const std::vector<CoverBox>& find(const TopGroup& group, const TopAxes& axes, const OutlineLines& lines,
                                    const std::vector<Seam>& seams, const TopRaster& raster,
                                    const CoverOptions& options);

 private:
  /// Outline on one line, along it, as sums over bins.
  struct Support {
    double at_m = 0.0;
    std::array<std::vector<float>, 2> sums;  // of the samples that end low / high there
  };
  /// Lines across one axis; those before keep their memory for the next group.
  struct SupportLines {
    std::vector<Support> kept;
    std::size_t count = 0;
    Support& add(double at_m);
    std::vector<Support>::iterator begin() { return kept.begin(); }
    std::vector<Support>::iterator end() { return kept.begin() + static_cast<std::ptrdiff_t>(count); }
  };
  void prepareLines(const TopGroup& group, const TopAxes& axes, const OutlineLines& lines,
                    const std::vector<Seam>& seams, const TopRaster& raster);
  double supported(const Support& line, std::size_t axis, std::size_t kind, double from, double to) const;
  bool surfaceBeyond(const TopRaster& raster, double at_m, std::size_t bin, std::size_t axis,
                     bool high) const;
  bool rate(const TopRaster& raster, const std::array<const Support*, 4>& sides, CoverBox& candidate) const;
  void collect(const TopRaster& raster, const CoverOptions& options);
  void choose(const TopRaster& raster, std::size_t next, double score);

  std::array<SupportLines, 2> lines_;
  std::vector<std::pair<double, double>> places_;  // length and place of what may become a line
  LocalBox bounds_;
  double pitch_m_ = 0.0;
  std::vector<CoverBox> candidates_;
  std::vector<std::size_t> chosen_;
  std::vector<std::size_t> best_;
  double best_score_ = 0.0;
  std::vector<CoverBox> result_;
};

}  // namespace mixed_palletizing::detection
