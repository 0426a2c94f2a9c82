// A cloud seen from straight above: heights and grey values on a grid of the floor.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/detection/work_region.hpp>

#include "base_cloud.hpp"

namespace mixed_palletizing::detection {

/// Heights that belong to a stack [m], and where it may stand.
struct RasterLimits {
  double low_m = 0.0;
  double high_m = 2.0;
  double cell_m = 0.002;
};

class HeightRaster {
 public:
  static constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

  /// The highest point of every cell; cells between two rows of pixels take the mean of their neighbours. Keeps its
  /// memory between calls. Returns the number of points with data.
  std::size_t fill(const BaseCloud& cloud, const WorkRegion& region, const RasterLimits& limits);

  int rows() const { return rows_; }
  int cols() const { return cols_; }
  double cell() const { return cell_m_; }
  /// Height that the stack begins at [m].
  double low() const { return low_limit_m_; }
  std::size_t size() const { return heights_.size(); }
  std::size_t index(int row, int col) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols_) + static_cast<std::size_t>(col);
  }
  bool holds(int row, int col) const { return row >= 0 && col >= 0 && row < rows_ && col < cols_; }

  /// Height [m] and grey value of a cell; kNone without data.
  float height(std::size_t cell) const { return heights_[cell]; }
  float gray(std::size_t cell) const { return grays_[cell]; }

  /// Middle of a cell, base frame [m]; rows grow with y.
  Eigen::Vector2d place(int row, int col) const {
    return origin_ + cell_m_ * Eigen::Vector2d(col + 0.5, row + 0.5);
  }
  /// (column, row) of a place, whole numbers being the middle of a cell.
  Eigen::Vector2d gridOf(const Eigen::Vector2d& place) const {
    return ((place - origin_) / cell_m_).array() - 0.5;
  }

 private:
  void findBounds(const BaseCloud& cloud, const WorkRegion& region, const RasterLimits& limits);
  void closeHoles();

  int rows_ = 0;
  int cols_ = 0;
  double cell_m_ = 0.002;
  double low_limit_m_ = 0.0;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  std::size_t valid_ = 0;
  Eigen::Array2f low_ = Eigen::Array2f::Zero();
  Eigen::Array2f high_ = Eigen::Array2f::Zero();
  std::vector<float> heights_;
  std::vector<float> grays_;
};

}  // namespace mixed_palletizing::detection
