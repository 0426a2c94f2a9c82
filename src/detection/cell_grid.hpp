// Blocks of pixels ("cells") with their mean place and height, in one pass over the cloud.
//
// The mean of a block has a fraction of the noise of a pixel, so that level surfaces can be told from steep ones
// cell by cell; single pixels are looked at again only along the outlines.
#pragma once

#include <cstdint>
#include <vector>

#include "base_cloud.hpp"
#include "clusters.hpp"

namespace mixed_palletizing::detection {

/// A block of pixels; means are over its points between the height limits.
struct Cell {
  float x = 0.0f;  ///< base frame [m]
  float y = 0.0f;
  float height = 0.0f;
  float spread = 0.0f;      ///< standard deviation of the heights [m]
  float depth = 0.0f;       ///< along the optical axis [m]
  std::uint8_t above = 0;   ///< points between the height limits
  std::uint8_t others = 0;  ///< points with data outside of them
};

/// Cells [begin, end) of one row that have points between the height limits.
struct CellRun {
  int row = 0;
  int begin = 0;
  int end = 0;
};

class CellGrid {
 public:
  /// Reads the whole cloud once; keeps its memory between calls. `cell_px`: side of a block, 2 to 8.
  void fill(const BaseCloud& cloud, const ClusterLimits& limits, int cell_px);

  int cellPx() const { return cell_px_; }
  int rows() const { return rows_; }
  int cols() const { return cols_; }
  const Cell& at(int row, int col) const { return cells_[index(row, col)]; }
  std::size_t index(int row, int col) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols_) + static_cast<std::size_t>(col);
  }
  std::size_t size() const { return cells_.size(); }
  const Cell& operator[](std::size_t i) const { return cells_[i]; }
  std::size_t validPoints() const { return valid_; }
  /// All cells with points between the height limits, row by row.
  const std::vector<CellRun>& runs() const { return runs_; }

  /// Calls visit(index, row, col) for those cells.
  template <typename Visit>
  void forEachFilled(Visit visit) const {
    for (const CellRun& run : runs_) {
      for (int col = run.begin; col < run.end; ++col) visit(index(run.row, col), run.row, col);
    }
  }

 private:
  /// Running sums of a cell over its rows, in the camera frame.
  struct Sums {
    float x = 0.0f, y = 0.0f, z = 0.0f;
    float first = 0.0f;  // height of the first point: keeps the squares small
    float height = 0.0f, squares = 0.0f;
    int above = 0, others = 0;
  };
  void addRow(const BaseCloud& cloud, const ClusterLimits& limits, int row);
  template <int kPx>
  void addCells(const BaseCloud& cloud, const ClusterLimits& limits, int row);
  void finishRow(const BaseCloud& cloud, int cell_row);

  int cell_px_ = 4;
  int rows_ = 0;
  int cols_ = 0;
  std::size_t valid_ = 0;
  std::vector<Cell> cells_;
  std::vector<CellRun> runs_;
  std::vector<Sums> sums_;      // of the cells of one row
  std::vector<float> heights_;  // of one row of pixels; not a number without data
  std::vector<std::uint8_t> marks_;
};

}  // namespace mixed_palletizing::detection
