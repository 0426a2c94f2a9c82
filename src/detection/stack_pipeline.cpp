// Boxes in a stack:
//   height_raster   the cloud from straight above
//   top_segments    its level surfaces: tops, or several tops side by side
//   top_picture     one of them, turned along the sides of its boxes
//   top_split       cuts along the seams between boxes
//   part_fit        the rectangle of each part
//   stack_height    height by the side faces in view
#include "stack_pipeline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lens_rays.hpp"
#include "refusal_text.hpp"
#include "stack_height.hpp"
#include "stage_clock.hpp"
#include "top_picture.hpp"
#include "top_split.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kCellSpacings = 0.8;  // of the points
constexpr double kStepSigmas = 2.5;    // of the noise: less is no step
constexpr double kFinestCell_m = 0.002;
constexpr double kHiddenShare =
    0.5;  // of a side that something higher borders: a piece of the top may be hidden
constexpr double kSideStddev_m = 0.05;   // of such a side
constexpr double kUnknownStddev = 0.5;   // of the height above the floor, for a height that is not known
constexpr double kStripShare = 4.0;      // length over width: more is a strip of a surface that goes on
constexpr double kSlenderShare = 8.0;    // height over width: more does not stand
constexpr double kKnownHeight_m = 0.02;  // standard deviation of a height by the sides: more is not known
constexpr double kBorder_px = 2.0;
constexpr int kDepthSamples = 64;  // along each side of the image

double medianDepth(const BaseCloud& cloud) {
  std::vector<double> depths;
  for (int row = 0; row < cloud.height(); row += std::max(1, cloud.height() / kDepthSamples)) {
    for (int col = 0; col < cloud.width(); col += std::max(1, cloud.width() / kDepthSamples)) {
      if (cloud.valid(row, col)) depths.push_back(static_cast<double>(cloud.view().point(row, col).z()));
    }
  }
  if (depths.empty()) return 1.0;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

/// True when a corner of a level rectangle is seen at the border of the image or beyond.
bool leavesImage(const BaseCloud& cloud, const geometry::Pose& camera_from_base,
                 const geometry::Rectangle& top, double top_m) {
  const auto rays = LensRays::fit(cloud.view(), {0, 0, cloud.width(), cloud.height()});
  if (!rays) return true;
  for (const Eigen::Vector2d& corner : top.corners()) {
    const auto pixel = rays->pixel(camera_from_base * Eigen::Vector3d(corner.x(), corner.y(), top_m));
    if (!pixel || !(pixel->x() > kBorder_px && pixel->x() < cloud.width() - 1 - kBorder_px)) return true;
    if (!(pixel->y() > kBorder_px && pixel->y() < cloud.height() - 1 - kBorder_px)) return true;
  }
  return false;
}

void setFlag(DetectedBox& box, BoxFlag flag) { box.flags = static_cast<std::uint8_t>(box.flags | flag); }

}  // namespace

StackPipeline::StackPipeline(const DetectionOptions& options) : options_(options), region_(options.region) {}

Detections StackPipeline::detect(const geometry::CloudView& view, const geometry::Pose& base_from_camera,
                                 bool keep_stages) {
  StageClock clock;
  const BaseCloud cloud(view, base_from_camera);
  Detections result;
  result.width = view.width;
  result.height = view.height;
  result.labels.assign(view.size(), 0);
  const SensorNoise noise = measureNoise(cloud, options_.cluster.min_height_m);
  clock.done("noise");
  camera_from_base_ = base_from_camera.inverse();
  const double depth = medianDepth(cloud);
  const double noise_m =
      std::hypot(noise.depth(depth), noise.ripple_m);  // ripple: tops wave as the floor does
  RasterLimits limits;
  limits.low_m = std::max(options_.stack.min_height_m, options_.noise.sigmas * noise.floor_stddev_m);
  limits.high_m = options_.cluster.max_height_m;
  limits.cell_m = std::max(kFinestCell_m, kCellSpacings * noise.spacing(depth));
  const std::size_t valid = raster_.fill(cloud, region_, limits);
  result.valid_ratio = static_cast<double>(valid) / static_cast<double>(view.size());
  clock.done("raster");
  step_m_ = std::max(options_.stack.step_m, kStepSigmas * noise_m);
  segments_.find(raster_, {std::tan(options_.stack.max_slope_rad), step_m_, noise_m, noise.ripple_m,
                           options_.box.min_side_m * options_.box.min_side_m});
  clock.done("tops");
  found_.clear();
  for (int i = 0; i < static_cast<int>(segments_.segments().size()); ++i)
    examineSegment(cloud, noise, i, result);
  clock.done("boxes");
  label(cloud, result);
  dropSparse(result);
  doubtGaps();
  for (const Found& found : found_) result.boxes.push_back(found.box);
  flagTouching(result);
  if (keep_stages) keepStages(cloud, result);
  clock.done("labels");
  result.stage_times = clock.times();
  return result;
}

void StackPipeline::examineSegment(const BaseCloud& cloud, const SensorNoise& noise, int number,
                                   Detections& result) {
  const TopPicture picture(cloud, camera_from_base_, raster_, segments_, number,
                           sideDirection(raster_, segments_, number), step_m_);
  for (const TopPart& part : splitTop(picture, {options_.box.min_side_m})) {
    const PartFit fit = fitPart(picture, part);
    const geometry::Rectangle top = fit.rectangle.lengthFirst();
    const double top_m = segments_.segments()[static_cast<std::size_t>(number)].heightAt(top.center);
    if (const auto refusal = judge(fit, top)) {
      reject(*refusal, top, top_m, result);
      continue;
    }
    const Found found = toBox(cloud, noise, number, fit);
    if (const auto refusal = judgeSolid(fit, found)) {
      reject(*refusal, top, top_m, result);
    } else {
      found_.push_back(found);
    }
  }
}

/// Whether a part is a rectangle of a box's size.
std::optional<Refusal> StackPipeline::judge(const PartFit& fit, const geometry::Rectangle& top) const {
  const BoxOptions& limits = options_.box;
  const std::string measured = text("the top is %.3f x %.3f m", top.size.x(), top.size.y());
  if (!(top.size.y() >= limits.min_side_m)) {
    return Refusal{RejectReason::kTooSmall,
                   measured + text(", a side is less than %.3f m", limits.min_side_m)};
  }
  if (!(top.size.x() <= limits.max_side_m)) {
    return Refusal{RejectReason::kTooLarge,
                   measured + text(", a side is more than %.3f m", limits.max_side_m)};
  }
  if (fit.filled < limits.min_rectangularity) {
    return Refusal{RejectReason::kNotRectangular,
                   measured + text(", the surface fills %.2f of that, less than %.2f", fit.filled,
                                   limits.min_rectangularity)};
  }
  return std::nullopt;
}

/// Whether a rectangle is a box for all that is seen of the rest of it.
std::optional<Refusal> StackPipeline::judgeSolid(const PartFit& fit, const Found& found) const {
  const Eigen::Vector3d& size = found.box.size;
  const std::string measured = text("the top is %.3f x %.3f m", size.x(), size.y());
  // Beside a long side that is hidden or cut off the surface goes on: a strip of a pallet or of a shelf shows there.
  const bool turned = fit.rectangle.size.x() < fit.rectangle.size.y();
  const bool hidden = turned ? std::max(fit.sides[1].above, fit.sides[3].above) >= kHiddenShare
                             : std::max(fit.sides[0].above, fit.sides[2].above) >= kHiddenShare;
  const bool cut = (found.box.flags & kTruncated) != 0;
  if ((hidden || cut) && size.x() > kStripShare * size.y()) {
    return Refusal{
        RejectReason::kNotRectangular,
        measured + text(", a strip %.1f times as long as wide of what goes on beyond its long side",
                        size.x() / size.y())};
  }
  // A height that is not known is at least what the sides show.
  if (size.z() > kSlenderShare * size.y()) {
    return Refusal{RejectReason::kTooLarge, measured + text(" and %.3f m high, %.1f times its width: a post",
                                                            size.z(), size.z() / size.y())};
  }
  return std::nullopt;
}

StackPipeline::Found StackPipeline::toBox(const BaseCloud& cloud, const SensorNoise& noise, int number,
                                          const PartFit& fit) const {
  const TopSegment& top = segments_.segments()[static_cast<std::size_t>(number)];
  Found found;
  found.segment = number;
  found.footprint = fit.rectangle.lengthFirst();
  DetectedBox& box = found.box;
  std::array<double, 4> side_stddev{};
  for (std::size_t i = 0; i < 4; ++i) {
    side_stddev[i] = std::hypot(fit.sides[i].stddev_m, noise.ripple_m);
    if (fit.sides[i].above < kHiddenShare) continue;
    side_stddev[i] = std::max(side_stddev[i], kSideStddev_m);
    setFlag(box, kOccluded);
  }
  const double top_m = top.heightAt(found.footprint.center);
  if (leavesImage(cloud, camera_from_base_, found.footprint, top_m)) {
    setFlag(box, kTruncated);
    for (double& stddev : side_stddev) stddev = std::max(stddev, kUnknownStddev * found.footprint.size.x());
  }
  const double top_stddev =
      std::hypot(top.rms_m / std::sqrt(static_cast<double>(top.cells.size())), noise.ripple_m);
  box.yaw_rad = found.footprint.yaw_rad;
  box.size.head<2>() = found.footprint.size;
  const bool swapped = fit.rectangle.size.x() < fit.rectangle.size.y();
  const double across_u = std::hypot(side_stddev[1], side_stddev[3]);
  const double across_v = std::hypot(side_stddev[0], side_stddev[2]);
  box.size_stddev.head<2>() =
      swapped ? Eigen::Vector2d(across_v, across_u) : Eigen::Vector2d(across_u, across_v);
  const auto height = heightOfSides(raster_, segments_, found.footprint, top_m, cloud.camera(), step_m_);
  if (height) {
    box.size.z() = height->height_m;
    box.size_stddev.z() = std::hypot(height->stddev_m, std::hypot(top_stddev, noise.ripple_m));
    if (height->stddev_m > kKnownHeight_m) setFlag(box, kHeightUnknown);
  } else {
    // Somewhere between its top and the floor; a box is seldom taller than it is wide.
    box.size.z() = std::min(top_m, box.size.y());
    box.size_stddev.z() = std::max(kUnknownStddev * top_m, kSideStddev_m);
    setFlag(box, kHeightUnknown);
  }
  box.top_center << found.footprint.center, top_m;
  box.top_normal = Eigen::Vector3d(-top.slope.x(), -top.slope.y(), 1.0).normalized();
  box.center = box.top_center - Eigen::Vector3d(0.0, 0.0, 0.5 * box.size.z());
  box.top_visibility = std::min(1.0, fit.filled);
  if (top.slope.norm() * box.size.head<2>().norm() > options_.top.uneven_m + noise.ripple_m)
    setFlag(box, kUnevenTop);
  const double place = 0.25 * (across_u * across_u + across_v * across_v);
  box.pose_covariance.diagonal() << place, place,
      std::pow(0.5 * box.size_stddev.z(), 2) + top_stddev * top_stddev, std::pow(top.slope.y(), 2) + 1e-6,
      std::pow(top.slope.x(), 2) + 1e-6, std::pow(fit.yaw_stddev_rad, 2);
  return found;
}

void StackPipeline::reject(const Refusal& refusal, const geometry::Rectangle& top, double top_m,
                           Detections& result) const {
  RejectedCluster rejected;
  rejected.reason = refusal.reason;
  rejected.text = refusal.text;
  rejected.centroid << top.center, top_m;
  Eigen::Vector2d reach = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : top.corners()) {
    reach = reach.cwiseMax((corner - top.center).cwiseAbs());
  }
  rejected.extent << 2.0 * reach, 0.0;
  result.rejected.push_back(rejected);
}

}  // namespace mixed_palletizing::detection
