#include "edge_walks.hpp"

#include <algorithm>
#include <cmath>

#include "surface_walk.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr int kLongWalk = 64;   // cells
constexpr int kMostGaps = 3;    // that one line of pixels is followed across
constexpr int kLeastStrip = 2;  // pixels behind a gap that are more than strays
constexpr int kFaceEvery = 4;   // every so many walks
constexpr double kBandSigmas = 3.5;
constexpr double kLeastBand = 0.0006;   // [m]
constexpr double kUnevenBand = 0.0015;  // [m] more where the surface is uneven
constexpr double kUnevenBend = 0.0005;  // [m] more where an uneven surface is followed
constexpr int kFollowedOn = 3;          // cells that it is followed for
constexpr double kFollowedFrom =
    0.004;                             // [m] before an end, where an uneven surface tells where it leads ...
constexpr double kFollowedTo = 0.016;  // ... up to here: nearer, edges are round
constexpr double kLeastJump = 0.008;   // [m]
constexpr double kJumpSigmas = 8.0;

/// Walks from the ends of the intervals of cells of one piece, along rows or along columns.
class PieceWalker {
 public:
  PieceWalker(const BaseCloud& cloud, const CellGrid& cells, const LevelPieces& pieces, int piece,
              const RayModel& rays, const WalkScale& scale, std::vector<EdgeSample>& samples)
      : cloud_(cloud),
        cells_(cells),
        pieces_(pieces),
        piece_(piece),
        rays_(rays),
        scale_(scale),
        samples_(samples) {}

  void walkLines(bool along_row) {
    const LevelPiece& p = pieces_.pieces()[static_cast<std::size_t>(piece_)];
    const int line_min = along_row ? p.row_min : p.col_min;
    const int line_max = along_row ? p.row_max : p.col_max;
    const int begin = along_row ? p.col_min : p.row_min;
    const int end = along_row ? p.col_max : p.row_max;
    for (int line = line_min; line <= line_max; ++line) {
      int before = -1;  // last cell of the interval before
      for (int i = begin; i <= end; ++i) {
        if (!member(along_row, line, i)) continue;
        const int first = i;
        while (i + 1 <= end && member(along_row, line, i + 1)) ++i;
        walkFrom(along_row, line, first, -1, before);
        int next = i + 1;
        while (next <= end && !member(along_row, line, next)) ++next;
        walkFrom(along_row, line, i, 1, next <= end ? next : -1);
        before = i;
      }
    }
  }

 private:
  bool member(bool along_row, int line, int i) const {
    return pieces_.pieceOf(along_row ? cells_.index(line, i) : cells_.index(i, line)) == piece_;
  }

  bool onOtherPiece(bool along_row, int line_px, int px) const {
    const int k = cells_.cellPx();
    const std::size_t cell =
        along_row ? cells_.index(line_px / k, px / k) : cells_.index(px / k, line_px / k);
    const int piece = pieces_.pieceOf(cell);
    return piece >= 0 && piece != piece_;
  }

  /// Walks along every pixel line of a cell. `other`: the next cell of the piece that way, -1 for none.
  void walkFrom(bool along_row, int line, int cell, int step, int other) {
    const int k = cells_.cellPx();
    const Lead lead = scale_.flat ? onPlane(along_row, line, cell) : followed(along_row, line, cell, step);
    const int lines = along_row ? cloud_.height() : cloud_.width();
    const int start = std::min(lead.cell * k + k / 2, (along_row ? cloud_.width() : cloud_.height()) - 1);
    for (int at = line * k; at < std::min((line + 1) * k, lines); ++at) {
      int first = start;
      for (int walks = 0; walks < kMostGaps; ++walks) {
        SurfaceWalk walk(cloud_, rays_, scale_, along_row ? at : first, along_row ? first : at,
                         along_row ? 0 : step, along_row ? step : 0,
                         walks == 0 ? lead.level : WalkLevel{lead.level.begin_m, 0.0f, 0});
        const int last = walk.go(k * kLongWalk);
        if (last < (walks == 0 ? 0 : kLeastStrip)) break;
        const int reached = (first + step * last - (other * k + k / 2)) * step;
        if (other >= 0 && reached >= -k / 2) break;  // walked through to the next cells of the piece
        if (walks > 0 && onOtherPiece(along_row, at, first + step * last))
          break;  // which is walked by itself
        samples_.push_back(walk.sample(at % kFaceEvery == 0));
        // Behind a wide gap a strip of the same level may be too narrow for cells of its own.
        const EdgeSample& s = samples_.back();
        if (s.beyond != Beyond::kHole || static_cast<double>(s.gap_m) < kWideSeam || other >= 0) break;
        first += step * walk.resumesAt();
      }
    }
  }

  /// Where a walk starts, and the heights that it goes by.
  struct Lead {
    int cell = 0;
    WalkLevel level;
  };

  const Cell& cellAt(bool along_row, int line, int i) const {
    return along_row ? cells_.at(line, i) : cells_.at(i, line);
  }

  Lead onPlane(bool along_row, int line, int cell) const {
    const Cell& from = cellAt(along_row, line, cell);
    const LevelPiece& p = pieces_.pieces()[static_cast<std::size_t>(piece_)];
    return {cell, {static_cast<float>(p.heightAt({from.x, from.y})), 0.0f, 0}};
  }

  /// The cells some way before an end lead to it by a line through their heights: those at the end may lie on a
  /// rounded edge.
  Lead followed(bool along_row, int line, int cell, int step) const {
    double n = 0.0, x = 0.0, xx = 0.0, h = 0.0, xh = 0.0;
    const Cell& last = cellAt(along_row, line, cell);
    int first = 0;  // cells back
    double start = last.height;
    for (int i = 1;; ++i) {
      const int at = cell - i * step;
      if (at < 0 || at >= (along_row ? cells_.cols() : cells_.rows()) || !member(along_row, line, at)) break;
      const Cell& there = cellAt(along_row, line, at);
      const double distance = std::hypot(there.x - last.x, there.y - last.y);
      if (distance > kFollowedTo) break;
      if (distance < kFollowedFrom) continue;
      if (first == 0) {
        first = i;
        start = there.height;
      }
      const double d = (first - i) * cells_.cellPx();
      const double off = there.height - start;
      n += 1.0;
      x += d;
      xx += d * d;
      h += off;
      xh += d * off;
    }
    const double spread = n * xx - x * x;
    if (n < 3.0 || !(spread > 0.0)) return {cell, {last.height, 0.0f, 0}};
    const double rise = (n * xh - x * h) / spread;
    return {cell - first * step,
            {static_cast<float>(start + (h - rise * x) / n), static_cast<float>(rise),
             (first + kFollowedOn) * cells_.cellPx()}};
  }

  const BaseCloud& cloud_;
  const CellGrid& cells_;
  const LevelPieces& pieces_;
  const int piece_;
  const RayModel& rays_;
  const WalkScale& scale_;
  std::vector<EdgeSample>& samples_;
};

}  // namespace

WalkScale walkScale(const LevelPiece& piece, const SensorNoise& noise, const RayModel& rays) {
  WalkScale scale;
  const double depth_noise = noise.depth(piece.depth_m);
  const Eigen::Vector2d pixel =
      rays.pixelOf({piece.center.x(), piece.center.y(), piece.height_m}).value_or(Eigen::Vector2d::Zero());
  scale.noise_m = depth_noise * std::abs(rays.ray(pixel.x(), pixel.y()).z());
  scale.flat = piece.rms_m < 0.5 * scale.noise_m + 0.0002;
  scale.band_m = std::max(kLeastBand, kBandSigmas * std::hypot(scale.noise_m, piece.rms_m)) +
                 (scale.flat ? 0.0 : kUnevenBand);
  scale.bend_m = scale.flat ? scale.band_m : std::max(kLeastBand, kBandSigmas * scale.noise_m) + kUnevenBend;
  // Errors that neighbours share are those of windows.
  scale.lost_share = noise.ripple_m > scale.noise_m ? 0.5 : 0.0;
  scale.jump_m = std::max(kLeastJump, kJumpSigmas * depth_noise);
  return scale;
}

void walkEdges(const BaseCloud& cloud, const CellGrid& cells, const LevelPieces& pieces, int piece,
               const RayModel& rays, const WalkScale& scale, std::vector<EdgeSample>& samples) {
  PieceWalker walker(cloud, cells, pieces, piece, rays, scale, samples);
  walker.walkLines(true);
  walker.walkLines(false);
}

}  // namespace mixed_palletizing::detection
