// From one rectangle of a cover to one box, or to the reason why it is none.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/detection/options.hpp>

#include "box_candidate.hpp"
#include "rectangle_cover.hpp"
#include "rectangle_fit.hpp"
#include "top_surface.hpp"

namespace mixed_palletizing::detection {

/// A cell of a top in the rectangle's axes.
struct SurfaceCell {
  double x, y, height, weight;
  double off;  ///< above the plane of the surface
};

/// What the boxes of one cloud share.
struct LevelContext {
  const BaseCloud& cloud;
  const CellGrid& cells;
  const LevelPieces& pieces;
  const SensorNoise& noise;
  const DetectionOptions& options;
};

/// Memory of fitTop(), kept between calls.
struct TopBuffers {
  FitBuffers fit;
  std::vector<SurfaceCell> cells;
};

/// Rise over run of a surface that is still a top.
constexpr double kSteepestTop = 0.15;

/// Why a surface with that rise over run is none.
Refusal tooSteep(double tilt);

/// The ends of the surface around a rectangle, by what they are [m of outline].
struct OutlineShares {
  double on_sides = 0.0;
  double off_sides = 0.0;
  double occluded = 0.0;
  double border = 0.0;
  double ink = 0.0;
  double all() const { return on_sides + off_sides + occluded + border + ink; }
};

/// A rectangle that passes for a top.
struct FittedTop {
  const TopGroup* group = nullptr;
  RectangleFit fit;
  TopSurface surface;
  OutlineShares outline;
  double visibility = 1.0;
  double seen_m2 = 0.0;  ///< of its surface
};

/// Fits, measures and judges one rectangle of a group's cover. The group must outlive the result.
std::variant<FittedTop, Refusal> fitTop(const LevelContext& context, const TopGroup& group,
                                        const TopAxes& axes, const TopRaster& raster, const CoverBox& cover,
                                        TopBuffers& buffers);

/// The box below a top, standing on the floor.
FoundBox describeTop(const LevelContext& context, const FittedTop& top);

/// Surface of the cells well inside a rectangle and its rounded edges, around a level. Dents count.
TopSurface measureCells(const LevelContext& context, const TopGroup& group, const RectangleFit& fit,
                        double level_m, std::vector<SurfaceCell>& cells);

}  // namespace mixed_palletizing::detection
