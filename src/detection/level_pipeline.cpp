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
//   refused_clusters  what everything else is
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
#include "refused_clusters.hpp"
#include "seam_search.hpp"
#include "stage_clock.hpp"
#include "top_groups.hpp"

namespace mixed_palletizing::detection {
namespace {

// Pieces of level surface smaller than this share of the smallest cluster are stray points.
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
    refused_.clear();
    const LevelContext context{cloud, cells_, pieces_, noise, options_};
    for (const TopGroup& group : groups) explain(context, group, clock);
    dropParts();
    completeHidden(context, tops_);
    for (const FittedTop& top : tops_) found_.push_back(describeTop(context, top));
    labelBoxes(cloud, cells_, limits, found_, result.labels, taken_);
    for (const FoundBox& box : found_) result.boxes.push_back(box.box);
    clock.done("labels");
    flagTouching(found_, options_.box.touching_distance_m + 2.0 * noise.floor_stddev_m, result.boxes);
    refused_.collect(cells_, pieces_, blobs_, taken_, static_cast<std::size_t>(options_.cluster.min_points),
                     result.rejected);
    if (keep_stages) result.stage_pixels = stagePixels(cloud, limits, {cells_, blobs_, pieces_, groups});
    result.stage_times = clock.times();
    return result;
  }

 private:
  void explain(const LevelContext& context, const TopGroup& group, StageClock& clock) {
    const LevelPiece& piece = pieces_.pieces()[static_cast<std::size_t>(group.largest)];
    const int blob = blobs_.blobOf(piece.cell);
    if (blob < 0 || blobs_.blobs()[static_cast<std::size_t>(blob)].points <
                        static_cast<std::size_t>(options_.cluster.min_points)) {
      return;
    }
    if (piece.slope.norm() > kSteepestTop) {
      refused_.add(group.largest, tooSteep(piece.slope.norm()));
      return;
    }
    TopAxes axes(piece.center, group.yaw_rad);
    findLines(group.samples, group.pixel_m, std::max(kMinLine, 6.0 * group.pixel_m), axes, line_buffers_,
              lines_);
    clock.done("lines");
    raster_.fill(context.cloud, cells_, pieces_, group, axes);
    CoverOptions cover;
    cover.min_side_m = kSideShare * options_.box.min_side_m;
    cover.max_side_m = kLargestShare * options_.box.max_side_m;
    const std::vector<Seam>& seams =
        seam_search_.find(context.cloud, pieces_, group, axes, lines_, raster_.bounds());
    clock.done("seams");
    const std::vector<CoverBox>& boxes = cover_.find(group, axes, lines_, seams, raster_, cover);
    clock.done("cover");
    if (boxes.empty()) {
      refused_.add(group.largest, withoutCover(raster_.bounds().size()));
    }
    for (const CoverBox& box : boxes) {
      const auto outcome = fitTop(context, group, axes, raster_, box, top_buffers_);
      if (const auto* refusal = std::get_if<Refusal>(&outcome)) {
        refused_.add(group.largest, *refusal);
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

  /// A level surface inside the footprint of a box and below its top is a part of that box.
  void dropParts() {
    std::sort(tops_.begin(), tops_.end(),
              [](const FittedTop& a, const FittedTop& b) { return a.seen_m2 > b.seen_m2; });
    kept_.clear();
    for (const FittedTop& top : tops_) {
      const bool part = std::any_of(kept_.begin(), kept_.end(), [&](const FittedTop& other) {
        return other.fit.rectangle.contains(top.fit.rectangle.center) &&
               top.surface.height_m < other.surface.height_m + other.group->scale.band_m;
      });
      if (!part) kept_.push_back(top);
    }
    std::swap(tops_, kept_);
  }

  const DetectionOptions& options_;
  CellGrid cells_;
  FloorBlobs blobs_;
  LevelPieces pieces_;
  TopGroups groups_;
  TopRaster raster_;
  RectangleCover cover_;
  SeamSearch seam_search_;
  LineBuffers line_buffers_;
  OutlineLines lines_;
  TopBuffers top_buffers_;
  std::vector<FittedTop> tops_, kept_;
  std::vector<FoundBox> found_;
  std::vector<char> taken_;  // by cell: 1 for those of boxes
  RefusedClusters refused_;
};

}  // namespace

std::unique_ptr<DetectionPipeline> makeLevelPipeline(const DetectionOptions& options) {
  return std::make_unique<LevelPipeline>(options);
}

}  // namespace mixed_palletizing::detection
