// What became of everything above the floor that is no box: every cluster has a reason.
#pragma once

#include <vector>

#include <mixed_palletizing/detection/detections.hpp>

#include "box_candidate.hpp"
#include "floor_blobs.hpp"
#include "level_pieces.hpp"

namespace mixed_palletizing::detection {

/// Keeps its memory between clouds.
class RefusedClusters {
 public:
  /// Forgets the cloud before.
  void clear() { refusals_.clear(); }

  /// Why the tops around a piece are no box.
  void add(int piece, const Refusal& refusal) { refusals_.push_back({piece, refusal}); }

  /// Appends a rejected cluster for every blob of at least a quarter of `min_points` that no box has cells of, and for
  /// every connected rest of `min_points` or more that the boxes leave of the others. `taken`: 1 for cells of boxes.
  void collect(const CellGrid& cells, const LevelPieces& pieces, const FloorBlobs& blobs,
               const std::vector<char>& taken, std::size_t min_points,
               std::vector<RejectedCluster>& rejected);

 private:
  struct Entry {
    int piece;
    Refusal refusal;
  };
  /// What the boxes leave of a blob.
  struct Rest {
    int blob = -1;
    int piece = -1;  // the largest with cells in it
  };
  void lookAtRests(const CellGrid& cells, const LevelPieces& pieces, const FloorBlobs& blobs,
                   const std::vector<char>& taken);
  const Refusal* refusalOf(const LevelPieces& pieces, const FloorBlobs& blobs, int blob) const;
  const Refusal* refusalOf(int piece) const;

  std::vector<Entry> refusals_;
  std::vector<char> held_;         // by blob: a box has cells of it
  std::vector<std::size_t> left_;  // by blob: points that are in no box's cells
  FloorBlobs rest_blobs_;
  std::vector<Rest> rests_;
};

}  // namespace mixed_palletizing::detection
