#include "cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mixed_palletizing::detection {
namespace {

/// Heights of a row of pixels above the floor; not a number where there is no data.
template <std::size_t kStep>
void heightsOfRow(const std::uint8_t* __restrict__ p, std::size_t step, const geometry::CloudView& view,
                  const Eigen::Vector3f& up, float offset, float* __restrict__ heights) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const float up_x = up.x();
  const float up_y = up.y();
  const float up_z = up.z();
  const int width = view.width;
  const std::size_t stride = kStep > 0 ? kStep : step;
  const std::size_t x_at = kStep > 0 ? 0 : view.x_offset;
  const std::size_t y_at = kStep > 0 ? 4 : view.y_offset;
  const std::size_t z_at = kStep > 0 ? 8 : view.z_offset;
  for (int col = 0; col < width; ++col, p += stride) {
    const float x = geometry::CloudView::readFloat(p + x_at);
    const float y = geometry::CloudView::readFloat(p + y_at);
    const float z = geometry::CloudView::readFloat(p + z_at);
    const float h = up_x * x + up_y * y + up_z * z + offset;
    heights[col] = z > 0.0f ? h : kNone;
  }
}

constexpr int kLargestCell = 8;  // [px]

// Marks of a pixel: the sum over a cell's row counts both.
constexpr std::uint8_t kValid = 1;   // has data
constexpr std::uint8_t kAbove = 16;  // lies above the floor

void markRow(const float* __restrict__ heights, std::size_t count, float low,
             std::uint8_t* __restrict__ marks) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool number = heights[i] - heights[i] == 0.0f;  // exactly for finite numbers
    marks[i] = static_cast<std::uint8_t>((number ? kValid : 0) + (heights[i] > low ? kAbove : 0));
  }
}

}  // namespace

void CellGrid::addRow(const BaseCloud& cloud, const ClusterLimits& limits, int row) {
  const geometry::CloudView& view = cloud.view();
  const Eigen::Vector3f up = cloud.upInCamera();
  const bool common = view.point_step == 16 && view.x_offset == 0 && view.y_offset == 4 && view.z_offset == 8;
  if (common) {
    heightsOfRow<16>(view.at(row, 0), 16, view, up, limits.camera_height_m, heights_.data());
  } else {
    heightsOfRow<0>(view.at(row, 0), view.point_step, view, up, limits.camera_height_m, heights_.data());
  }
  markRow(heights_.data(), heights_.size(), limits.low_m, marks_.data());
  switch (cell_px_) {
    case 2:
      return addCells<2>(cloud, limits, row);
    case 3:
      return addCells<3>(cloud, limits, row);
    case 4:
      return addCells<4>(cloud, limits, row);
    default:
      return addCells<0>(cloud, limits, row);
  }
}

template <int kPx>
void CellGrid::addCells(const BaseCloud& cloud, const ClusterLimits& limits, int row) {
  const geometry::CloudView& view = cloud.view();
  const bool region = limits.region.limited();
  const int px = kPx > 0 ? kPx : cell_px_;
  const float low = limits.low_m;
  const float high = limits.high_m;
  int valid_in_row = 0;
  for (int cell = 0, begin = 0; begin < view.width; ++cell, begin += px) {
    const std::uint8_t* marks = marks_.data() + begin;
    int sum = 0;
    for (int i = 0; i < px; ++i) sum += marks[i];
    const int valid = sum % kAbove;
    valid_in_row += valid;
    if (sum < kAbove) {
      sums_[static_cast<std::size_t>(cell)].others += valid;
      continue;
    }
    const int end = std::min(view.width, begin + px);
    const float* h = heights_.data() + begin;
    Sums sums = sums_[static_cast<std::size_t>(cell)];
    sums.others += valid;
    for (int i = 0; i < end - begin; ++i) {
      if (!(h[i] > low && h[i] < high)) continue;
      const Eigen::Vector3f p = view.point(row, begin + i);
      if (region && !limits.region.contains(cloud.toBase(p))) continue;
      if (sums.above++ == 0) sums.first = h[i];
      const float d = h[i] - sums.first;
      sums.x += p.x();
      sums.y += p.y();
      sums.z += p.z();
      sums.height += d;
      sums.squares += d * d;
      --sums.others;
    }
    sums_[static_cast<std::size_t>(cell)] = sums;
  }
  valid_ += static_cast<std::size_t>(valid_in_row);
}

void CellGrid::finishRow(const BaseCloud& cloud, int cell_row) {
  for (int col = 0; col < cols_; ++col) {
    Sums& sums = sums_[static_cast<std::size_t>(col)];
    Cell cell;
    cell.above = static_cast<std::uint8_t>(sums.above);
    cell.others = static_cast<std::uint8_t>(sums.others);
    if (sums.above > 0) {
      const float n = static_cast<float>(sums.above);
      const Eigen::Vector3f mean = Eigen::Vector3f(sums.x, sums.y, sums.z) / n;
      const Eigen::Vector3f place = cloud.toBase(mean);
      cell.x = place.x();
      cell.y = place.y();
      cell.depth = mean.z();
      const float shift = sums.height / n;
      cell.height = sums.first + shift;
      cell.spread = std::sqrt(std::max(0.0f, sums.squares / n - shift * shift));
      const bool goes_on = !runs_.empty() && runs_.back().row == cell_row && runs_.back().end == col;
      if (!goes_on) runs_.push_back({cell_row, col, col});
      runs_.back().end = col + 1;
    }
    cells_[index(cell_row, col)] = cell;
    sums = Sums{};
  }
}

void CellGrid::fill(const BaseCloud& cloud, const ClusterLimits& limits, int cell_px) {
  cell_px_ = cell_px;
  rows_ = (cloud.height() + cell_px - 1) / cell_px;
  cols_ = (cloud.width() + cell_px - 1) / cell_px;
  valid_ = 0;
  cells_.resize(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(cols_));
  runs_.clear();
  sums_.assign(static_cast<std::size_t>(cols_), Sums{});
  heights_.resize(static_cast<std::size_t>(cloud.width()));
  marks_.assign(heights_.size() + kLargestCell, 0);  // the last cell may reach beyond the row
  for (int row = 0; row < cloud.height(); ++row) {
    addRow(cloud, limits, row);
    if ((row + 1) % cell_px == 0 || row + 1 == cloud.height()) finishRow(cloud, row / cell_px);
  }
}

}  // namespace mixed_palletizing::detection
