#include "floor_blobs.hpp"

#include <algorithm>

namespace mixed_palletizing::detection {
namespace {

// Of a cell's points: with fewer above the floor it is a stray point or a mixed pixel, which joins nothing.
constexpr int kLeastAbove = 2;

}  // namespace

int FloorBlobs::root(int cell) {
  while (labels_[static_cast<std::size_t>(cell)] != cell) {
    int& parent = labels_[static_cast<std::size_t>(cell)];
    parent = labels_[static_cast<std::size_t>(parent)];
    cell = parent;
  }
  return cell;
}

void FloorBlobs::find(const CellGrid& cells) {
  labels_.assign(cells.size(), -1);
  const auto join = [&](std::size_t a, std::size_t b) {
    if (labels_[b] < 0) return;
    const int one = root(static_cast<int>(a));
    const int two = root(static_cast<int>(b));
    labels_[static_cast<std::size_t>(std::max(one, two))] = std::min(one, two);
  };
  for (int row = 0; row < cells.rows(); ++row) {
    for (int col = 0; col < cells.cols(); ++col) {
      const std::size_t i = cells.index(row, col);
      if (cells[i].above < kLeastAbove) continue;
      labels_[i] = static_cast<int>(i);
      if (col > 0) join(i, i - 1);
      if (row > 0) join(i, i - static_cast<std::size_t>(cells.cols()));
    }
  }
  numbers_.assign(cells.size(), -1);
  blobs_.clear();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (labels_[i] < 0) continue;
    const auto r = static_cast<std::size_t>(root(static_cast<int>(i)));
    if (numbers_[r] < 0) {
      numbers_[r] = static_cast<int>(blobs_.size());
      blobs_.emplace_back();
    }
    const Cell& cell = cells[i];
    Blob& blob = blobs_[static_cast<std::size_t>(numbers_[r])];
    const Eigen::Vector3d place(cell.x, cell.y, cell.height);
    blob.points += cell.above;
    blob.centroid += cell.above * place;
    blob.low = blob.low.cwiseMin(place);
    blob.high = blob.high.cwiseMax(place);
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (labels_[i] >= 0) labels_[i] = root(static_cast<int>(i));
  }
  for (int& label : labels_) {
    if (label >= 0) label = numbers_[static_cast<std::size_t>(label)];
  }
  for (Blob& blob : blobs_) blob.centroid /= static_cast<double>(blob.points);
}

}  // namespace mixed_palletizing::detection
