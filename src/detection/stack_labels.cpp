// What StackPipeline tells about its boxes: their pixels, which of them touch, and the stages for debugging.
#include <array>
#include <cmath>
#include <utility>

#include "refusal_text.hpp"
#include "stack_pipeline.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kWidestGap_m = 0.010;   // between two tops that may be counted to one of them
constexpr double kGapStddev_m = 0.0025;  // of a side at such a gap

void setFlag(DetectedBox& box, BoxFlag flag) { box.flags = static_cast<std::uint8_t>(box.flags | flag); }

}  // namespace

/// The points of each box's top.
void StackPipeline::label(const BaseCloud& cloud, Detections& result) {
  if (found_.empty()) return;
  std::vector<std::uint16_t> owners(raster_.size(), 0);
  for (int row = 0; row < raster_.rows(); ++row) {
    for (int col = 0; col < raster_.cols(); ++col) {
      const std::size_t cell = raster_.index(row, col);
      if (segments_.segmentOf(cell) < 0) continue;
      for (std::size_t i = 0; i < found_.size(); ++i) {
        if (found_[i].segment != segments_.segmentOf(cell) ||
            !found_[i].footprint.contains(raster_.place(row, col)))
          continue;
        owners[cell] = static_cast<std::uint16_t>(i + 1);
      }
    }
  }
  const auto step = static_cast<float>(step_m_);
  for (int row = 0; row < cloud.height(); ++row) {
    for (int col = 0; col < cloud.width(); ++col) {
      if (!cloud.valid(row, col)) continue;
      const Eigen::Vector3f p = cloud.point(row, col);
      const Eigen::Vector2d grid = raster_.gridOf(p.head<2>().cast<double>());
      const int r = static_cast<int>(std::lround(grid.y()));
      const int c = static_cast<int>(std::lround(grid.x()));
      if (!raster_.holds(r, c)) continue;
      const std::size_t cell = raster_.index(r, c);
      if (owners[cell] == 0 || std::abs(p.z() - raster_.height(cell)) > step) continue;
      result.labels[static_cast<std::size_t>(row) * static_cast<std::size_t>(cloud.width()) +
                    static_cast<std::size_t>(col)] = owners[cell];
      ++found_[owners[cell] - 1u].box.point_count;
    }
  }
}

/// Boxes of fewer points than the smallest cluster are noise: they leave, and the labels are counted anew.
void StackPipeline::dropSparse(Detections& result) {
  const auto least = static_cast<std::uint32_t>(options_.cluster.min_points);
  std::vector<std::uint16_t> renamed{0};
  std::vector<Found> kept;
  for (const Found& found : found_) {
    const std::uint32_t points = found.box.point_count;
    if (points >= least) kept.push_back(found);
    renamed.push_back(points >= least ? static_cast<std::uint16_t>(kept.size()) : std::uint16_t{0});
    if (points >= least) continue;
    reject({RejectReason::kTooFewPoints, text("the top has %u points, less than %u", points, least)},
           found.footprint, found.box.top_center.z(), result);
  }
  if (kept.size() == found_.size()) return;
  found_ = std::move(kept);
  for (std::uint16_t& label : result.labels) label = renamed[label];
}

/// A narrow gap between two tops is counted to one of them as easily as to none: their sizes across it are less sure.
void StackPipeline::doubtGaps() {
  for (Found& found : found_) {
    const geometry::Rectangle& r = found.footprint;
    std::array<bool, 4> sides{};  // x low, x high, y low, y high
    for (const Found& other : found_) {
      if (&other == &found || geometry::distance(r, other.footprint) > kWidestGap_m) continue;
      // The side that the other lies behind: across which it is farthest, for the size.
      const Eigen::Vector2d d = other.footprint.center - r.center;
      const Eigen::Vector2d local(d.dot(r.axisX()) / r.size.x(), d.dot(r.axisY()) / r.size.y());
      const std::size_t axis = std::abs(local.x()) > std::abs(local.y()) ? 0 : 1;
      sides[2 * axis + (local(static_cast<Eigen::Index>(axis)) > 0.0 ? 1 : 0)] = true;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (!sides[i]) continue;
      const Eigen::Vector2d axis = i < 2 ? r.axisX() : r.axisY();
      double& stddev = found.box.size_stddev(i < 2 ? 0 : 1);
      stddev = std::hypot(stddev, kGapStddev_m);
      found.box.pose_covariance.topLeftCorner<2, 2>() +=
          0.25 * kGapStddev_m * kGapStddev_m * axis * axis.transpose();
    }
  }
}

void StackPipeline::flagTouching(Detections& result) const {
  const double reach = options_.box.touching_distance_m + raster_.cell();
  for (std::size_t i = 0; i < found_.size(); ++i) {
    for (std::size_t k = i + 1; k < found_.size(); ++k) {
      if (found_[i].segment != found_[k].segment ||
          geometry::distance(found_[i].footprint, found_[k].footprint) > reach) {
        continue;
      }
      setFlag(result.boxes[i], kTouching);
      setFlag(result.boxes[k], kTouching);
    }
  }
}

void StackPipeline::keepStages(const BaseCloud& cloud, Detections& result) const {
  StagePixels floor{"floor", {}};
  StagePixels clusters{"clusters", {}};
  StagePixels tops{"tops", {}};
  for (int row = 0; row < cloud.height(); ++row) {
    for (int col = 0; col < cloud.width(); ++col) {
      if (!cloud.valid(row, col)) continue;
      const auto pixel = static_cast<std::uint32_t>(row * cloud.width() + col);
      const Eigen::Vector3f p = cloud.point(row, col);
      const Eigen::Vector2d grid = raster_.gridOf(p.head<2>().cast<double>());
      const int r = static_cast<int>(std::lround(grid.y()));
      const int c = static_cast<int>(std::lround(grid.x()));
      if (!raster_.holds(r, c) || !(static_cast<double>(p.z()) > options_.stack.min_height_m)) {
        floor.pixels.push_back(pixel);
        continue;
      }
      clusters.pixels.push_back(pixel);
      if (segments_.segmentOf(raster_.index(r, c)) >= 0) tops.pixels.push_back(pixel);
    }
  }
  result.stage_pixels = {floor, clusters, tops, StagePixels{"edges", {}}};
}

}  // namespace mixed_palletizing::detection
