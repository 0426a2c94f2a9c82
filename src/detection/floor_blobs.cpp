#include "floor_blobs.hpp"

#include <algorithm>

namespace mixed_palletizing::detection {
namespace {

// Of a cell's points: with fewer above the floor it is a stray point or a mixed pixel, which joins nothing.
constexpr int kLeastAbove = 2;
constexpr double kFilled =
    0.7;  // of a cell's pixels, in what is left beside a box: edges have mixed pixels around them
constexpr int kCoded = -2;  // less the number of a blob: a label that is no link any more

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
  join(cells, [&](std::size_t i) { return cells[i].above >= kLeastAbove; });
}

void FloorBlobs::findRest(const CellGrid& cells, const std::vector<char>& taken) {
  const double least = kFilled * cells.cellPx() * cells.cellPx();
  join(cells, [&](std::size_t i) { return taken[i] == 0 && cells[i].above >= least; });
}

template <typename Belongs>
void FloorBlobs::join(const CellGrid& cells, Belongs belongs) {
  labels_.assign(cells.size(), -1);
  const auto meet = [&](std::size_t a, std::size_t b) {
    if (labels_[b] < 0) return;
    const int one = root(static_cast<int>(a));
    const int two = root(static_cast<int>(b));
    labels_[static_cast<std::size_t>(std::max(one, two))] = std::min(one, two);
  };
  cells.forEachFilled([&](std::size_t i, int row, int col) {
    if (!belongs(i)) return;
    labels_[i] = static_cast<int>(i);
    if (col > 0) meet(i, i - 1);
    if (row > 0) meet(i, i - static_cast<std::size_t>(cells.cols()));
  });
  // Links lead to cells before their own, so that every cell finds the code of its blob at its link's end.
  const auto codeOf = [](std::size_t number) { return kCoded - static_cast<int>(number); };
  blobs_.clear();
  cells.forEachFilled([&](std::size_t i, int, int) {
    if (labels_[i] == -1) return;
    const auto link = static_cast<std::size_t>(labels_[i]);
    if (link == i) blobs_.emplace_back();
    labels_[i] = link == i ? codeOf(blobs_.size() - 1) : labels_[link];
    const Cell& cell = cells[i];
    Blob& blob = blobs_[static_cast<std::size_t>(kCoded - labels_[i])];
    const Eigen::Vector3d place(cell.x, cell.y, cell.height);
    blob.points += cell.above;
    blob.centroid += cell.above * place;
    blob.low = blob.low.cwiseMin(place);
    blob.high = blob.high.cwiseMax(place);
  });
  cells.forEachFilled([&](std::size_t i, int, int) {
    if (labels_[i] != -1) labels_[i] = kCoded - labels_[i];
  });
  for (Blob& blob : blobs_) blob.centroid /= static_cast<double>(blob.points);
}

}  // namespace mixed_palletizing::detection
