#include "top_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

constexpr int kCells = 6;             // per side
constexpr double kInner = 0.92;       // of the half side: rounded and mixed edges stay out
constexpr double kFilledShare = 0.3;  // of the mean cell
constexpr std::size_t kMinPoints = 12;

struct Cell {
  std::size_t count = 0;
  double sum = 0.0;
};

}  // namespace

double unevenness(const BaseCloud& cloud, const RunRange& top, const geometry::Rectangle& rectangle) {
  std::array<Cell, kCells * kCells> cells{};
  const Eigen::Vector2f center = rectangle.center.cast<float>();
  const Eigen::Vector2f axis = rectangle.axisX().cast<float>();
  const Eigen::Array2f inner = (0.5 * kInner * rectangle.size).cast<float>();
  const Eigen::Array2f per_cell = 0.5f * kCells / inner;
  std::size_t count = 0;
  double sum = 0.0;
  const int stride = meanStride(pixelCount(top));
  for (const Run& run : top) {
    if (run.row % stride != 0) continue;
    for (int col = run.begin; col < run.end; col += stride) {
      const Eigen::Vector3f p = cloud.point(run.row, col);
      const Eigen::Vector2f d = p.head<2>() - center;
      const Eigen::Array2f local(d.dot(axis), axis.x() * d.y() - axis.y() * d.x());
      if ((local.abs() >= inner).any()) continue;
      const Eigen::Array2i index = ((local + inner) * per_cell).cast<int>().min(kCells - 1);
      Cell& cell = cells[static_cast<std::size_t>(index.y() * kCells + index.x())];
      ++cell.count;
      cell.sum += static_cast<double>(p.z());
      ++count;
      sum += static_cast<double>(p.z());
    }
  }
  const double filled =
      std::max<double>(kMinPoints, kFilledShare * static_cast<double>(count) / (kCells * kCells));
  const double mean = sum / static_cast<double>(std::max<std::size_t>(count, 1));
  double largest = 0.0;
  for (const Cell& cell : cells) {
    if (static_cast<double>(cell.count) < filled) continue;
    largest = std::max(largest, std::abs(cell.sum / static_cast<double>(cell.count) - mean));
  }
  return largest;
}

}  // namespace mixed_palletizing::detection
