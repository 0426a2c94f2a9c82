#include "box_candidate.hpp"

#include <algorithm>
#include <cmath>

#include "height.hpp"
#include "refusal_text.hpp"
#include "top_surface.hpp"
#include "top_visibility.hpp"
#include "uncertainty.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kSeenShare = 0.01;  // of the outline: what less of it says is noise
constexpr std::size_t kMinTopPoints = 30;

}  // namespace

/// What the stages of one cluster share.
struct BoxCandidate::Context {
  const BaseCloud& cloud;
  const geometry::Pose& base_from_camera;
  const SensorNoise& noise;
  double floor_m;
  const RunRange& cluster;
  const ClusterShape& shape;

  double depth() const { return (cloud.camera() - shape.centroid).norm(); }
  FitScale scale(double top_stddev_m) const { return {noise.spacing(depth()), top_stddev_m, noise.ripple_m}; }
};

std::optional<Refusal> BoxCandidate::findTop(const Context& context) {
  const auto patch =
      patchHeight(context.cloud, context.cluster, context.shape, options_.top.height_patch_radius_m);
  const double window =
      std::max(4.0 * options_.top.slice_m, options_.noise.sigmas * context.noise.floor_stddev_m);
  const TopLevel level = findTopLevel(context.shape.profile, patch, context.floor_m, window);
  const auto band = separateTop(context.shape.profile, level, options_);
  if (!band || level.peak_density < options_.top.slice_ratio * level.side_density) {
    return Refusal{
        RejectReason::kNoTopPlane,
        text("a slice at %.3f m holds %.1f times the points of a slice through the sides, less than %.1f",
             level.height_m, level.peak_density / std::max(level.side_density, 1e-9),
             options_.top.slice_ratio)};
  }
  const auto piece = findTopPiece(context.cloud, context.cluster, *band, pieces_);
  const std::size_t points = piece ? pixelCount(pieces_.component(*piece)) : 0;
  if (points < kMinTopPoints) {
    return Refusal{RejectReason::kNoTopPlane, text("the top at %.3f m holds %zu points, less than %zu",
                                                   level.height_m, points, kMinTopPoints)};
  }
  top_ = pieces_.component(*piece);
  band_ = *band;
  height_ = measureHeight(context.cloud, top_);
  return std::nullopt;
}

std::variant<RectangleFit, Refusal> BoxCandidate::findRectangle(const Context& context, StageClock& clock) {
  const FitScale scale = context.scale(height_.stddev_m);
  const double step = std::max(options_.top.search_depth_m, options_.noise.sigmas * height_.stddev_m);
  tracer_.trace(context.cloud, top_, height_.mean_m, band_, step, outline_);
  points_.clear();
  for (const OutlineSample& sample : outline_) points_.push_back(sample.measured);
  clock.done("outline");
  const geometry::Polygon hull = convexHull(points_);
  if (hull.size() < 3) {
    return Refusal{RejectReason::kNoTopPlane, text("the %zu points of the top lie on a line", height_.count)};
  }
  hull_area_ = geometry::signedArea(hull);
  const double min_edge = std::max({options_.top.min_edge_length_m, options_.noise.sigmas * height_.stddev_m,
                                    2.0 * options_.noise.spacings * scale.spacing_m});
  const EdgeRectangle start = rectangleFromEdges(hull, findEdges(hull, min_edge, options_.top));
  const RectangleFit fit = keepRectangle(start, scale);
  const double tolerance = std::max(0.003, options_.noise.sigmas * height_.stddev_m);
  match_ = matchOutline(outline_, fit.rectangle, tolerance, options_.noise.spacings);
  clock.done("rectangle");
  return fit;
}

std::optional<Refusal> BoxCandidate::judge(const Context& context, const RectangleFit& fit) {
  const geometry::Rectangle r = fit.rectangle.lengthFirst();
  const std::string size = text("the top is %.3f x %.3f m", r.size.x(), r.size.y());
  if (!(r.size.y() >= options_.box.min_side_m)) {
    return Refusal{RejectReason::kTooSmall,
                   size + text(", a side is less than %.3f m", options_.box.min_side_m)};
  }
  if (!(r.size.x() <= options_.box.max_side_m)) {
    return Refusal{RejectReason::kTooLarge,
                   size + text(", a side is more than %.3f m", options_.box.max_side_m)};
  }
  // Half a pixel all around belongs to the rectangle but not to the hull of the points.
  const Eigen::Vector2d seen = (r.size.array() - context.scale(0.0).spacing_m).max(1e-6);
  const double rectangularity = hull_area_ / (seen.x() * seen.y());
  if (rectangularity < options_.box.min_rectangularity) {
    return Refusal{RejectReason::kNotRectangular,
                   size + text(", its hull fills %.2f of that, less than %.2f", rectangularity,
                               options_.box.min_rectangularity)};
  }
  if (match_.on_sides_ratio < options_.box.min_outline_ratio) {
    return Refusal{RejectReason::kNotRectangular,
                   size + text(", %.2f of its outline lies on the sides, less than %.2f",
                               match_.on_sides_ratio, options_.box.min_outline_ratio)};
  }
  return std::nullopt;
}

FoundBox BoxCandidate::describe(const Context& context, const RectangleFit& fit) const {
  FoundBox found;
  found.footprint = fit.rectangle.lengthFirst();
  found.top_m = band_.high_m;
  DetectedBox& box = found.box;
  const geometry::Rectangle& r = found.footprint;
  const TopSurface surface = measureSurface(context.cloud, top_, r, height_.mean_m, band_.low_m);
  const double height = surface.height_m;
  box.top_center = Eigen::Vector3d(r.center.x(), r.center.y(), height);
  box.center = Eigen::Vector3d(r.center.x(), r.center.y(), 0.5 * height);
  box.yaw_rad = r.yaw_rad;
  box.size = Eigen::Vector3d(r.size.x(), r.size.y(), height);
  box.top_visibility = topVisibility(context.cloud, context.base_from_camera, top_, r, height);
  estimateUncertainty(fit, surface, context.noise.ripple_m, options_.box.max_side_m, box);
  unsigned flags = 0;
  if (match_.occluded_ratio > kSeenShare) flags |= kOccluded;
  if (match_.border_ratio > kSeenShare) flags |= kTruncated;
  if (surface.uneven_m > std::max(options_.top.uneven_m, 2.0 * context.noise.floor_stddev_m))
    flags |= kUnevenTop;
  if (fit.foundSides() < 4) flags |= kIncomplete;
  box.flags = static_cast<std::uint8_t>(flags);
  return found;
}

std::variant<FoundBox, Refusal> BoxCandidate::examine(const BaseCloud& cloud,
                                                      const geometry::Pose& base_from_camera,
                                                      const SensorNoise& noise, double floor_m,
                                                      const RunRange& cluster, const ClusterShape& shape,
                                                      StageClock& clock) {
  const Context context{cloud, base_from_camera, noise, floor_m, cluster, shape};
  top_ = RunRange{};
  outline_.clear();
  const auto no_top = findTop(context);
  clock.done("tops");
  if (no_top) return *no_top;
  const auto fit = findRectangle(context, clock);
  if (const auto* refusal = std::get_if<Refusal>(&fit)) return *refusal;
  if (const auto refusal = judge(context, std::get<RectangleFit>(fit))) return *refusal;
  FoundBox found = describe(context, std::get<RectangleFit>(fit));
  clock.done("boxes");
  return found;
}

}  // namespace mixed_palletizing::detection
