// Level surfaces of a height raster: tops of boxes, or of several boxes side by side.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "height_raster.hpp"

namespace mixed_palletizing::detection {

/// A connected level surface. Heights follow height_m + slope . (place - center).
struct TopSegment {
  std::vector<std::size_t> cells;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double height_m = 0.0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double rms_m = 0.0;

  double heightAt(const Eigen::Vector2d& place) const { return height_m + slope.dot(place - center); }
};

struct SegmentLimits {
  double max_slope = 0.17;  ///< rise over run
  double step_m = 0.012;    ///< neighbours that differ more are two surfaces
  double noise_m = 0.0;     ///< standard deviation of a height
  double ripple_m = 0.0;    ///< and what of it neighbouring heights share
  double min_area_m2 = 0.001;
};

class TopSegments {
 public:
  void find(const HeightRaster& raster, const SegmentLimits& limits);

  const std::vector<TopSegment>& segments() const { return segments_; }

  /// Number of the segment that a cell belongs to; -1 for none.
  int segmentOf(std::size_t cell) const { return labels_[cell]; }

 private:
  void markLevel(const HeightRaster& raster, const SegmentLimits& limits);
  void grow(const HeightRaster& raster, const SegmentLimits& limits, std::size_t seed);
  void widen(const HeightRaster& raster, const SegmentLimits& limits);

  std::vector<bool> level_;
  std::vector<int> labels_;
  std::vector<TopSegment> segments_;
  int reach_ = 2;  // cells on each side over which a slope is measured
};

}  // namespace mixed_palletizing::detection
