// One level surface, turned so that the sides of its boxes run along rows and columns.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/geometry/pose.hpp>

#include "top_segments.hpp"

namespace mixed_palletizing::detection {

/// What a cell of a top's picture shows.
enum class TopCell : std::uint8_t {
  kTop,
  kBelow,  ///< something lower
  kAbove,  ///< something higher
  kNoData,
};

/// Grid along the axes of a yaw; u counts columns, v rows, whole numbers are the middle of a cell.
class TopPicture {
 public:
  /// One segment and a margin around it, as the camera sees it: every cell lies on the segment's plane and shows the
  /// pixel that looks at it. That holds where the sensor smears depth at an edge, too. `number`: of the segment.
  TopPicture(const BaseCloud& cloud, const geometry::Pose& camera_from_base, const HeightRaster& raster,
             const TopSegments& segments, int number, double yaw_rad, double step_m);

  int cols() const { return cols_; }
  int rows() const { return rows_; }
  double cell() const { return cell_m_; }
  double yaw() const { return yaw_rad_; }
  bool holds(int u, int v) const { return u >= 0 && v >= 0 && u < cols_ && v < rows_; }
  TopCell kind(int u, int v) const { return kinds_[index(u, v)]; }
  float gray(int u, int v) const { return grays_[index(u, v)]; }
  bool isTop(int u, int v) const { return holds(u, v) && kind(u, v) == TopCell::kTop; }

  /// Place in the base frame [m] of a place in the grid.
  Eigen::Vector2d place(const Eigen::Vector2d& uv) const;

  /// Grey value of the top that half of its cells lie below.
  float medianGray() const { return median_gray_; }

 private:
  void setBounds(const HeightRaster& raster, const TopSegment& segment);
  void look(const BaseCloud& cloud, const geometry::Pose& camera_from_base, const HeightRaster& raster,
            const TopSegments& segments, int number, double step_m);
  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(cols_) + static_cast<std::size_t>(u);
  }

  int cols_ = 0;
  int rows_ = 0;
  double cell_m_ = 0.0;
  double yaw_rad_ = 0.0;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();  // of the grid's axes, base frame
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();     // first cell along the axes [m]
  float median_gray_ = 0.0f;
  std::vector<TopCell> kinds_;
  std::vector<float> grays_;
};

/// Direction [rad], within a quarter turn, of the sides of a segment's boxes: that of most steps of height and of grey.
double sideDirection(const HeightRaster& raster, const TopSegments& segments, int number);

}  // namespace mixed_palletizing::detection
