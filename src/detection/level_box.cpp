#include "level_box.hpp"

#include <algorithm>
#include <cmath>

#include "rectangle_sides.hpp"
#include "refusal_text.hpp"
#include "uncertainty.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kSeenShare = 0.01;          // of the outline: what less of it says is noise
constexpr double kSeenLength = 0.006;        // [m] or so much of it
constexpr double kInsideMargin = 0.008;      // [m] around a rectangle: ends that it has to explain
constexpr double kContactShare = 0.5;        // of a side
constexpr double kContactStddev = 0.0006;    // [m] of a side known by a neighbour: half of a narrow gap
constexpr std::size_t kIncompleteShare = 4;  // times the smallest cluster: points of a top with missing sides
constexpr double kAboveTop = 0.02;           // [m] points so far above a level top still belong to the box
constexpr double kOnSide = 0.003;            // [m]

OutlineShares outlineOf(const TopGroup& group, const geometry::Rectangle& r, double tolerance) {
  OutlineShares outline;
  const Axes axes(r);
  const Eigen::Array2d half = 0.5 * r.size.array();
  for (const EdgeSample& s : group.samples) {
    const Eigen::Vector2d local = axes.local(s.place);
    const Eigen::Array2d beyond = local.array().abs() - half;
    if ((beyond > kInsideMargin).any()) continue;
    const double length = 0.5 * static_cast<double>(s.pixel_m);  // rows and columns both walk the outline
    if (s.beyond == Beyond::kOccluder) outline.occluded += length;
    if (s.beyond == Beyond::kBorder) outline.border += length;
    if (s.beyond == Beyond::kInk) outline.ink += length;
    if (!s.isEdge()) continue;
    const bool on_side = (beyond.abs() < tolerance).any();
    (on_side ? outline.on_sides : outline.off_sides) += length;
  }
  return outline;
}

FitScale scaleOf(const LevelContext& context, const TopGroup& group) {
  const LevelPiece& piece = context.pieces.pieces()[static_cast<std::size_t>(group.largest)];
  FitScale scale;
  scale.spacing_m = group.pixel_m;
  scale.noise_m = group.scale.noise_m;
  scale.ripple_m = context.noise.ripple_m;
  scale.uneven_m = group.scale.flat ? 0.0 : piece.rms_m;
  scale.bend_m = group.scale.bend_m;
  scale.camera = context.cloud.camera();
  scale.camera.z() -= piece.height_m;
  return scale;
}

geometry::Rectangle rectangleOf(const TopAxes& axes, const LocalBox& box) {
  geometry::Rectangle r;
  r.center = axes.place(0.5 * (box.low + box.high));
  r.size = box.size();
  r.yaw_rad = axes.yaw_rad;
  return r;
}

/// A side where the surface goes on into a neighbour has no outline; the cover knows it from the seam, or from where
/// the neighbour's own side runs on.
void knowContacts(const CoverBox& cover, double pixel_m, RectangleFit& fit) {
  // Sides of the fit run: low v, high u, high v, low u.
  constexpr std::array<std::size_t, 4> kCoverSide{2, 1, 3, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t k = kCoverSide[i];
    if (fit.sides[i].found || cover.support[k] + cover.cut[k] < kContactShare) continue;
    fit.sides[i].found = true;
    fit.sides[i].stddev_m = kContactStddev + pixel_m;
  }
}

std::optional<Refusal> judge(const LevelContext& context, const geometry::Rectangle& r,
                             const OutlineShares& outline, const RectangleFit& fit, std::size_t points) {
  const BoxOptions& limits = context.options.box;
  const std::string size = text("the top is %.3f x %.3f m", r.size.x(), r.size.y());
  if (!(r.size.y() >= limits.min_side_m)) {
    return Refusal{RejectReason::kTooSmall, size + text(", a side is less than %.3f m", limits.min_side_m)};
  }
  if (!(r.size.x() <= limits.max_side_m)) {
    return Refusal{RejectReason::kTooLarge, size + text(", a side is more than %.3f m", limits.max_side_m)};
  }
  const double seen = outline.on_sides + outline.off_sides;
  if (outline.on_sides < limits.min_outline_ratio * seen) {
    return Refusal{RejectReason::kNotRectangular,
                   size + text(", %.2f of its outline lies on the sides, less than %.2f",
                               outline.on_sides / seen, limits.min_outline_ratio)};
  }
  if (fit.foundSides() < 4 &&
      points < kIncompleteShare * static_cast<std::size_t>(context.options.cluster.min_points)) {
    return Refusal{RejectReason::kTooFewPoints,
                   size + text(", not all of its sides are seen, and %zu points", points)};
  }
  const bool hidden = outline.occluded + outline.border + outline.ink > kSeenShare * outline.all();
  if (fit.foundSides() < 2 || (fit.foundSides() < 3 && !hidden)) {
    return Refusal{RejectReason::kNotRectangular,
                   size + text(", only %d sides have a straight outline", fit.foundSides())};
  }
  return std::nullopt;
}

}  // namespace

Refusal tooSteep(double tilt) {
  return {RejectReason::kNoTopPlane,
          text("the surface is tilted by %.0f degrees", std::atan(tilt) * 180.0 / M_PI)};
}

std::variant<FittedTop, Refusal> fitTop(const LevelContext& context, const TopGroup& group,
                                        const TopAxes& axes, const TopRaster& raster, const CoverBox& cover,
                                        TopBuffers& buffers) {
  EdgeRectangle start;
  start.rectangle = rectangleOf(axes, cover.box);
  FittedTop top;
  top.group = &group;
  top.fit = fitRectangle(group.samples, start, scaleOf(context, group), buffers.fit);
  knowContacts(cover, group.pixel_m, top.fit);
  const LevelPiece& piece = context.pieces.pieces()[static_cast<std::size_t>(group.largest)];
  const geometry::Rectangle& r = top.fit.rectangle;
  const double tolerance = std::max({kOnSide, 2.5 * group.pixel_m, 0.5 * context.noise.floor_stddev_m});
  top.outline = outlineOf(group, top.fit.ends, tolerance);
  if (const auto refusal = judge(context, r.lengthFirst(), top.outline, top.fit, piece.points))
    return *refusal;
  top.surface = measureCells(context, group, top.fit, piece.heightAt(r.center), buffers.cells);
  if (top.surface.slope.norm() > kSteepestTop) return tooSteep(top.surface.slope.norm());
  const TopRaster::Count seen = raster.count(cover.box);
  top.visibility = std::min(1.0, static_cast<double>(seen.top) / std::max(1, seen.all - seen.free));
  top.seen_m2 = seen.top * raster.pitch() * raster.pitch();
  return top;
}

FoundBox describeTop(const LevelContext& context, const FittedTop& top) {
  FoundBox found;
  found.footprint = top.fit.rectangle.lengthFirst();
  found.top_m = top.surface.height_m + std::max(top.group->scale.band_m, kAboveTop);
  DetectedBox& box = found.box;
  const geometry::Rectangle& r = found.footprint;
  const double height = top.surface.height_m;
  box.top_center = Eigen::Vector3d(r.center.x(), r.center.y(), height);
  box.center = Eigen::Vector3d(r.center.x(), r.center.y(), 0.5 * height);
  box.top_normal = top.surface.normal();
  box.yaw_rad = r.yaw_rad;
  box.size = Eigen::Vector3d(r.size.x(), r.size.y(), height);
  box.top_visibility = top.visibility;
  estimateUncertainty(top.fit, top.surface, context.noise.ripple_m, context.options.box.max_side_m, box);
  unsigned flags = 0;
  const double noteworthy = std::max(kSeenLength, kSeenShare * top.outline.all());
  if (top.outline.occluded > noteworthy) flags |= kOccluded;
  if (top.outline.border > noteworthy) flags |= kTruncated;
  if (top.surface.uneven_m > std::max(context.options.top.uneven_m, 2.0 * context.noise.floor_stddev_m)) {
    flags |= kUnevenTop;
  }
  if (top.fit.foundSides() < 4) flags |= kIncomplete;
  box.flags = static_cast<std::uint8_t>(flags);
  return found;
}

}  // namespace mixed_palletizing::detection
