// Boxes as level surfaces bounded by rectangles:
//   sensor_noise      how far thresholds must be raised for this sensor
//   cell_grid         one pass over the cloud: blocks of pixels with their mean height above the floor
//   level_pieces      cells that go on into each other without a step
//   edge_walks, surface_walk   where each piece ends, to a fraction of a pixel, and what lies beyond
//   top_groups        pieces that may be parts of one top
//   outline_lines,    the directions and lines of a group's outline, seams across it, and the fewest rectangles
//   seam_search,      that explain what was seen
//   top_raster, rectangle_cover
//   rectangle_fit     each rectangle fitted to its outline
//   hidden_sides      how far sides that nothing shows may lie
//   level_box, top_cells, uncertainty   what the rectangle is worth
//   box_labels        the pixels of each box
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "box_labels.hpp"
#include "detection_pipeline.hpp"
#include "floor_blobs.hpp"
#include "hidden_sides.hpp"
#include "level_box.hpp"
#include "level_stages.hpp"
#include "refusal_text.hpp"
#include "seam_search.hpp"
#include "stage_clock.hpp"
#include "top_groups.hpp"

namespace mixed_palletizing::detection {
namespace {

// Blobs smaller than this share of the smallest cluster are stray points, not even worth a reason; nor are pieces of
// level surface that small.
constexpr int kStrayDivisor = 4;
constexpr double kCellLength = 0.002;  // [m] that a cell should measure
constexpr double kCellNoise = 18.0;    // square of a cell's side in pixels, over the noise in pixels
constexpr double kMinLine = 0.012;     // [m] of outline that make a line
constexpr double kSideShare = 0.5;     // of the smallest side: rectangles that the cover may hold
constexpr double kLargestShare = 3.0;  // of the largest side

int cellSize(const SensorNoise& noise, double depth_m) {
  const double spacing = std::max(noise.spacing(depth_m), 1e-6);
  const double by_noise = std::sqrt(kCellNoise * noise.depth(depth_m) / spacing);
  return std::clamp(static_cast<int>(std::lround(std::max(by_noise, kCellLength / spacing))), 2, 8);
}

void flagTouching(const std::vector<FoundBox>& found, double distance_m, std::vector<DetectedBox>& boxes) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (std::size_t k = i + 1; k < found.size(); ++k) {
      if (geometry::distance(found[i].footprint, found[k].footprint) > distance_m) continue;
      boxes[i].flags = static_cast<std::uint8_t>(boxes[i].flags | kTouching);
      boxes[k].flags = static_cast<std::uint8_t>(boxes[k].flags | kTouching);
    }
  }
}

class LevelPipeline : public DetectionPipeline {
 public:
  explicit LevelPipeline(const DetectionOptions& options) : options_(options) {}

  Detections detect(const geometry::CloudView& view, const geometry::Pose& base_from_camera,
                    bool keep_stages) override {
    StageClock clock;
    const BaseCloud cloud(view, base_from_camera);
    Detections result;
    result.width = view.width;
    result.height = view.height;
    result.labels.assign(view.size(), 0);
    const SensorNoise noise = measureNoise(cloud, options_.cluster.min_height_m);
    clock.done("noise");
    const ClusterLimits limits(options_, noise, cloud);
    cells_.fill(cloud, limits, cellSize(noise, noise.scene_depth_m));
    result.valid_ratio = static_cast<double>(cells_.validPoints()) / static_cast<double>(view.size());
    clock.done("cells");
    blobs_.find(cells_);
    pieces_.find(cells_, noise, static_cast<std::size_t>(options_.cluster.min_points) / kStrayDivisor);
    clock.done("pieces");
    const std::vector<TopGroup>& groups = groups_.find(cloud, cells_, noise, pieces_);
    clock.done("outlines");
    tops_.clear();
    found_.clear();
    refused_.assign(blobs_.blobs().size(), {});
    const LevelContext context{cloud, cells_, pieces_, noise, options_};
    for (const TopGroup& group : groups) explain(context, group, clock);
    dropParts();
    completeHidden(context, tops_);
    for (const FittedTop& top : tops_) found_.push_back(describeTop(context, top));
    labelBoxes(cloud, cells_, limits, found_, result.labels);
    for (const FoundBox& box : found_) result.boxes.push_back(box.box);
    clock.done("labels");
    flagTouching(found_, options_.box.touching_distance_m + 2.0 * noise.floor_stddev_m, result.boxes);
    collectRefused(limits, result);
    if (keep_stages) result.stage_pixels = stagePixels(cloud, limits, {cells_, blobs_, pieces_, groups});
    result.stage_times = clock.times();
    return result;
  }

 private:
  void explain(const LevelContext& context, const TopGroup& group, StageClock& clock) {
    const LevelPiece& piece = pieces_.pieces()[static_cast<std::size_t>(group.largest)];
    const int blob = blobOf(piece, group.largest);
    if (blob < 0 || blobs_.blobs()[static_cast<std::size_t>(blob)].points <
                        static_cast<std::size_t>(options_.cluster.min_points)) {
      return;
    }
    if (piece.slope.norm() > kSteepestTop) {
      refuse(group, tooSteep(piece.slope.norm()));
      return;
    }
    TopAxes axes(piece.center, group.yaw_rad);
    const OutlineLines lines =
        findLines(group.samples, group.pixel_m, std::max(kMinLine, 6.0 * group.pixel_m), axes);
    clock.done("lines");
    raster_.fill(context.cloud, cells_, pieces_, group, axes);
    CoverOptions cover;
    cover.min_side_m = kSideShare * options_.box.min_side_m;
    cover.max_side_m = kLargestShare * options_.box.max_side_m;
    const std::vector<Seam>& seams =
        seam_search_.find(context.cloud, pieces_, group, axes, lines, raster_.bounds());
    clock.done("seams");
    const std::vector<CoverBox>& boxes = cover_.find(group, axes, lines, seams, raster_, cover);
    clock.done("cover");
    if (boxes.empty()) {
      refuse(group, withoutCover(raster_.bounds().size()));
    }
    for (const CoverBox& box : boxes) {
      const auto outcome = fitTop(context, group, axes, raster_, box);
      if (const auto* refusal = std::get_if<Refusal>(&outcome)) {
        refuse(group, *refusal);
      } else {
        tops_.push_back(std::get<FittedTop>(outcome));
      }
    }
    clock.done("boxes");
  }

  /// Why no rectangle was found for a top with these bounds.
  Refusal withoutCover(const Eigen::Vector2d& size) const {
    const BoxOptions& limits = options_.box;
    const std::string bounds = text("the top is %.3f x %.3f m", size.maxCoeff(), size.minCoeff());
    if (size.minCoeff() < limits.min_side_m) {
      return {RejectReason::kTooSmall, bounds + text(", a side is less than %.3f m", limits.min_side_m)};
    }
    if (size.maxCoeff() > limits.max_side_m) {
      return {RejectReason::kTooLarge, bounds + text(", a side is more than %.3f m", limits.max_side_m)};
    }
    return {RejectReason::kNotRectangular, bounds + text(", no rectangle explains its outline")};
  }

  /// The reason stays with the blob that the group's largest piece lies in.
  void refuse(const TopGroup& group, const Refusal& refusal) {
    const LevelPiece& piece = pieces_.pieces()[static_cast<std::size_t>(group.largest)];
    const int blob = blobOf(piece, group.largest);
    if (blob >= 0 && refused_[static_cast<std::size_t>(blob)].text.empty()) {
      refused_[static_cast<std::size_t>(blob)] = refusal;
    }
  }

  int blobOf(const LevelPiece& piece, int number) const {
    for (int row = piece.row_min; row <= piece.row_max; ++row) {
      for (int col = piece.col_min; col <= piece.col_max; ++col) {
        const std::size_t cell = cells_.index(row, col);
        if (pieces_.pieceOf(cell) == number) return blobs_.blobOf(cell);
      }
    }
    return -1;
  }

  /// A level surface inside the footprint of a box and below its top is a part of that box.
  void dropParts() {
    const auto points = [&](const FittedTop& top) {
      return pieces_.pieces()[static_cast<std::size_t>(top.group->largest)].points;
    };
    std::stable_sort(tops_.begin(), tops_.end(), [&](const FittedTop& a, const FittedTop& b) {
      return std::make_pair(points(a), a.fit.rectangle.area()) >
             std::make_pair(points(b), b.fit.rectangle.area());
    });
    std::vector<FittedTop> kept;
    for (const FittedTop& top : tops_) {
      const bool part = std::any_of(kept.begin(), kept.end(), [&](const FittedTop& other) {
        return other.fit.rectangle.contains(top.fit.rectangle.center) &&
               top.surface.height_m < other.surface.height_m + other.group->scale.band_m;
      });
      if (!part) kept.push_back(top);
    }
    tops_ = std::move(kept);
  }

  void collectRefused(const ClusterLimits& limits, Detections& result) const {
    const auto min_points = static_cast<std::size_t>(options_.cluster.min_points);
    for (std::size_t i = 0; i < blobs_.blobs().size(); ++i) {
      const Blob& blob = blobs_.blobs()[i];
      if (blob.points < min_points / kStrayDivisor) continue;
      const bool part = std::any_of(found_.begin(), found_.end(), [&](const FoundBox& box) {
        return box.footprint.contains(blob.centroid.head<2>(), static_cast<double>(limits.distance_m)) &&
               blob.centroid.z() < box.top_m;
      });
      if (part) continue;
      Refusal why = refused_[i];
      if (blob.points < min_points) {
        why = {RejectReason::kTooFewPoints,
               std::to_string(blob.points) + " points, less than " + std::to_string(min_points)};
      } else if (why.text.empty()) {
        if (holdsBox(blob)) continue;
        why = {RejectReason::kNoTopPlane,
               "no level surface among its " + std::to_string(blob.points) + " points"};
      }
      result.rejected.push_back({why.reason, why.text, blob.centroid, blob.extent()});
    }
  }

  bool holdsBox(const Blob& blob) const {
    return std::any_of(found_.begin(), found_.end(), [&](const FoundBox& box) {
      const Eigen::Vector2d c = box.footprint.center;
      return (c.array() > blob.low.head<2>().array()).all() &&
             (c.array() < blob.high.head<2>().array()).all();
    });
  }

  const DetectionOptions& options_;
  CellGrid cells_;
  FloorBlobs blobs_;
  LevelPieces pieces_;
  TopGroups groups_;
  TopRaster raster_;
  RectangleCover cover_;
  SeamSearch seam_search_;
  std::vector<FittedTop> tops_;
  std::vector<FoundBox> found_;
  std::vector<Refusal> refused_;  // by blob; an empty text: nothing to say
};

}  // namespace

std::unique_ptr<DetectionPipeline> makeLevelPipeline(const DetectionOptions& options) {
  return std::make_unique<LevelPipeline>(options);
}

}  // namespace mixed_palletizing::detection
