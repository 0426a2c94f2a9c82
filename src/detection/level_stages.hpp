// What the stages of the level pipeline kept, pixel by pixel, for debugging.
#pragma once

#include <vector>

#include <mixed_palletizing/detection/detections.hpp>

#include "floor_blobs.hpp"
#include "top_raster.hpp"

namespace mixed_palletizing::detection {

struct LevelStages {
  const CellGrid& cells;
  const FloorBlobs& blobs;
  const LevelPieces& pieces;
  const std::vector<TopGroup>& groups;
};

/// Stages floor, clusters, tops, edges.
std::vector<StagePixels> stagePixels(const BaseCloud& cloud, const ClusterLimits& limits,
                                     const LevelStages& stages);

}  // namespace mixed_palletizing::detection
