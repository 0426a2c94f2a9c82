#include "refused_clusters.hpp"

#include <algorithm>
#include <string>

namespace mixed_palletizing::detection {
namespace {

// Blobs smaller than this share of the smallest cluster are stray points, not even worth a reason.
constexpr std::size_t kStrayDivisor = 4;

RejectedCluster clusterOf(const Refusal& why, const Blob& blob) {
  return {why.reason, why.text, blob.centroid, blob.extent()};
}

Refusal withoutTop(const Blob& blob) {
  return {RejectReason::kNoTopPlane, "no level surface among its " + std::to_string(blob.points) + " points"};
}

}  // namespace

const Refusal* RefusedClusters::refusalOf(int piece) const {
  const auto entry = std::find_if(refusals_.begin(), refusals_.end(),
                                  [piece](const Entry& candidate) { return candidate.piece == piece; });
  return entry != refusals_.end() ? &entry->refusal : nullptr;
}

/// The first refusal of a piece in a blob.
const Refusal* RefusedClusters::refusalOf(const LevelPieces& pieces, const FloorBlobs& blobs,
                                          int blob) const {
  const auto entry = std::find_if(refusals_.begin(), refusals_.end(), [&](const Entry& candidate) {
    return blobs.blobOf(pieces.pieces()[static_cast<std::size_t>(candidate.piece)].cell) == blob;
  });
  return entry != refusals_.end() ? &entry->refusal : nullptr;
}

void RefusedClusters::lookAtRests(const CellGrid& cells, const LevelPieces& pieces, const FloorBlobs& blobs,
                                  const std::vector<char>& taken) {
  rest_blobs_.findRest(cells, taken);
  rests_.assign(rest_blobs_.blobs().size(), {});
  const auto points = [&](int piece) { return pieces.pieces()[static_cast<std::size_t>(piece)].points; };
  cells.forEachFilled([&](std::size_t i, int, int) {
    if (rest_blobs_.blobOf(i) < 0) return;
    Rest& rest = rests_[static_cast<std::size_t>(rest_blobs_.blobOf(i))];
    rest.blob = blobs.blobOf(i);
    const int piece = pieces.pieceOf(i);
    if (piece >= 0 && (rest.piece < 0 || points(piece) > points(rest.piece))) rest.piece = piece;
  });
}

void RefusedClusters::collect(const CellGrid& cells, const LevelPieces& pieces, const FloorBlobs& blobs,
                              const std::vector<char>& taken, std::size_t min_points,
                              std::vector<RejectedCluster>& rejected) {
  held_.assign(blobs.blobs().size(), 0);
  left_.assign(held_.size(), 0);
  cells.forEachFilled([&](std::size_t i, int, int) {
    if (blobs.blobOf(i) < 0) return;
    const auto blob = static_cast<std::size_t>(blobs.blobOf(i));
    if (taken[i] != 0) {
      held_[blob] = 1;
    } else {
      left_[blob] += cells[i].above;
    }
  });
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Blob& blob = blobs.blobs()[i];
    if (held_[i] != 0 || blob.points < min_points / kStrayDivisor) continue;
    if (blob.points < min_points) {
      rejected.push_back(
          clusterOf({RejectReason::kTooFewPoints,
                     std::to_string(blob.points) + " points, less than " + std::to_string(min_points)},
                    blob));
      continue;
    }
    const Refusal* refusal = refusalOf(pieces, blobs, static_cast<int>(i));
    rejected.push_back(clusterOf(refusal != nullptr ? *refusal : withoutTop(blob), blob));
  }
  bool any = false;
  for (std::size_t i = 0; i < held_.size(); ++i) any = any || (held_[i] != 0 && left_[i] >= min_points);
  if (!any) return;
  lookAtRests(cells, pieces, blobs, taken);
  for (std::size_t i = 0; i < rests_.size(); ++i) {
    const Blob& blob = rest_blobs_.blobs()[i];
    if (blob.points < min_points || held_[static_cast<std::size_t>(rests_[i].blob)] == 0) continue;
    const Refusal* refusal = refusalOf(rests_[i].piece);
    rejected.push_back(clusterOf(refusal != nullptr ? *refusal : withoutTop(blob), blob));
  }
}

}  // namespace mixed_palletizing::detection
