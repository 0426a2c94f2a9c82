// Everything above the floor, as connected blobs of cells: to say of each what became of it.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "cell_grid.hpp"

namespace mixed_palletizing::detection {

struct Blob {
  std::size_t points = 0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< base frame [m]
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9);
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-1e9);
  Eigen::Vector3d extent() const { return high - low; }
};

class FloorBlobs {
 public:
  /// Keeps its memory between calls.
  void find(const CellGrid& cells);

  /// The same of the cells that are not `taken` and have points above the floor nearly everywhere.
  void findRest(const CellGrid& cells, const std::vector<char>& taken);

  const std::vector<Blob>& blobs() const { return blobs_; }
  /// Number of the blob of a cell; -1 without points above the floor.
  int blobOf(std::size_t cell) const { return labels_[cell]; }

 private:
  template <typename Belongs>
  void join(const CellGrid& cells, Belongs belongs);
  int root(int cell);

  std::vector<int> labels_;
  std::vector<Blob> blobs_;
};

}  // namespace mixed_palletizing::detection
