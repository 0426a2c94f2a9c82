#include "level_stages.hpp"

namespace mixed_palletizing::detection {

std::vector<StagePixels> stagePixels(const BaseCloud& cloud, const ClusterLimits& limits,
                                     const LevelStages& stages) {
  StagePixels floor{"floor", {}};
  StagePixels clusters{"clusters", {}};
  StagePixels tops{"tops", {}};
  StagePixels edges{"edges", {}};
  const int k = stages.cells.cellPx();
  for (int row = 0; row < cloud.height(); ++row) {
    for (int col = 0; col < cloud.width(); ++col) {
      if (!cloud.valid(row, col)) continue;
      const auto pixel = static_cast<std::uint32_t>(row * cloud.width() + col);
      const float height = cloud.point(row, col).z();
      if (height <= limits.low_m) {
        floor.pixels.push_back(pixel);
        continue;
      }
      if (height >= limits.high_m) continue;
      const std::size_t cell = stages.cells.index(row / k, col / k);
      if (stages.blobs.blobOf(cell) >= 0) clusters.pixels.push_back(pixel);
      if (stages.pieces.pieceOf(cell) >= 0) tops.pixels.push_back(pixel);
    }
  }
  for (const TopGroup& group : stages.groups) {
    for (const EdgeSample& s : group.samples) {
      edges.pixels.push_back(static_cast<std::uint32_t>(s.row * cloud.width() + s.col));
    }
  }
  return {floor, clusters, tops, edges};
}

}  // namespace mixed_palletizing::detection
