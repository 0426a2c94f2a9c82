#include "top_groups.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {
namespace {

constexpr int kRayMargin = 40;  // [px] around a piece, from which rays are taken too
constexpr double kNear = 0.30;  // [m] between pieces of one top
constexpr double kLevelTolerance = 0.0015;
constexpr double kLevelSigmas = 4.0;
constexpr double kUnevenShare = 2.0;      // of the roughness of both pieces
constexpr double kSameYaw = 0.05;         // [rad]
constexpr std::size_t kYawSamples = 250;  // of a piece whose yaw is to be believed
constexpr std::size_t kOpenSamples = 4;   // that see more of the level, or something before it
constexpr double kInsideShare = 0.95;     // of a dent's outline, that lies within the bounds of the top
constexpr double kEnclosedShare = 0.55;   // of a dent's outline, where the top begins
constexpr int kRimCells = 4;              // on the slope of a dent, between its floor and the top

/// Distance between two upright rectangles.
double distanceOf(const LevelPiece& a, const LevelPiece& b) {
  const Eigen::Vector2d gap = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Eigen::Vector2d::Zero());
  return gap.norm();
}

/// Whether the outline borders on a piece there.
bool isBeside(const CellGrid& cells, const LevelPieces& pieces, const EdgeSample& s, int piece) {
  const int row = s.row / cells.cellPx();
  const int col = s.col / cells.cellPx();
  for (int d = -kRimCells; d <= kRimCells; ++d) {
    const int r = row + (s.along_row ? 0 : d);
    const int c = col + (s.along_row ? d : 0);
    if (r < 0 || c < 0 || r >= cells.rows() || c >= cells.cols()) continue;
    if (pieces.pieceOf(cells.index(r, c)) == piece) return true;
  }
  return false;
}

double medianPixel(const std::vector<EdgeSample>& samples, std::vector<float>& pixels) {
  pixels.clear();
  for (const EdgeSample& s : samples) pixels.push_back(s.pixel_m);
  const auto middle = pixels.begin() + static_cast<std::ptrdiff_t>(pixels.size() / 2);
  std::nth_element(pixels.begin(), middle, pixels.end());
  return static_cast<double>(*middle);
}

}  // namespace

void TopGroups::trace(const BaseCloud& cloud, const CellGrid& cells, const SensorNoise& noise,
                      const LevelPieces& pieces, std::size_t index) {
  const LevelPiece& piece = pieces.pieces()[index];
  Outline& outline = outlines_[index];
  outline.samples.clear();
  outline.usable = false;
  outline.dent_of.reset();
  const int k = cells.cellPx();
  outline.box =
      PixelBox{piece.row_min * k, (piece.row_max + 1) * k - 1, piece.col_min * k, (piece.col_max + 1) * k - 1}
          .grown(0, cloud.width(), cloud.height());
  if (!outline.rays.fit(cloud, outline.box.grown(kRayMargin, cloud.width(), cloud.height()))) return;
  outline.scale = walkScale(piece, noise, outline.rays);
  walkEdges(cloud, cells, pieces, static_cast<int>(index), outline.rays, outline.scale, outline.samples);
  if (outline.samples.empty()) return;
  outline.usable = true;
  outline.pixel_m = medianPixel(outline.samples, pixels_);
  outline.yaw_rad = sharpestYaw(outline.samples, outline.pixel_m, lines_);
  const TopAxes axes(Eigen::Vector2d::Zero(), outline.yaw_rad);
  outline.bounds = LocalBox::none();
  for (const EdgeSample& s : outline.samples) outline.bounds.include(axes.local(s.place));
  const auto open = std::count_if(outline.samples.begin(), outline.samples.end(), [](const EdgeSample& s) {
    return s.beyond == Beyond::kHole || s.beyond == Beyond::kOccluder || s.beyond == Beyond::kInk ||
           s.beyond == Beyond::kNoData;
  });
  outline.open = static_cast<std::size_t>(open) >= kOpenSamples;
}

/// A small piece a little below a larger one that ends on it nearly everywhere: the floor of a dent.
bool TopGroups::isDent(const CellGrid& cells, const LevelPieces& pieces, std::size_t small,
                       std::size_t large) const {
  const LevelPiece& one = pieces.pieces()[small];
  const LevelPiece& two = pieces.pieces()[large];
  if (static_cast<double>(one.points) > kDentShare * static_cast<double>(two.points)) return false;
  const double depth = two.heightAt(one.center) - one.height_m;
  if (depth < 0.0 || depth > kDeepestDent) return false;
  const Outline& dent = outlines_[small];
  const Outline& around = outlines_[large];
  const TopAxes axes(Eigen::Vector2d::Zero(), around.yaw_rad);
  std::size_t inside = 0;
  std::size_t enclosed = 0;
  for (const EdgeSample& s : dent.samples) {
    inside += around.bounds.contains(axes.local(s.place)) ? 1 : 0;
    enclosed += isBeside(cells, pieces, s, static_cast<int>(large)) ? 1 : 0;
  }
  const double all = static_cast<double>(dent.samples.size());
  return static_cast<double>(inside) > kInsideShare * all &&
         static_cast<double>(enclosed) > kEnclosedShare * all;
}

/// A dent takes no part in the groups.
void TopGroups::findDents(const CellGrid& cells, const LevelPieces& pieces) {
  const std::size_t count = pieces.pieces().size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < count && outlines_[i].usable && !outlines_[i].dent_of; ++k) {
      if (k != i && outlines_[k].usable && isDent(cells, pieces, i, k)) outlines_[i].dent_of = k;
    }
  }
  for (std::size_t i = 0; i < count; ++i) outlines_[i].usable = outlines_[i].usable && !outlines_[i].dent_of;
}

bool TopGroups::together(const LevelPieces& pieces, std::size_t a, std::size_t b) const {
  const Outline& one = outlines_[a];
  const Outline& two = outlines_[b];
  if (!one.usable || !two.usable || !one.open || !two.open) return false;
  const LevelPiece& large = pieces.pieces()[pieces.pieces()[a].points > pieces.pieces()[b].points ? a : b];
  const LevelPiece& small = pieces.pieces()[&large == &pieces.pieces()[a] ? b : a];
  if (distanceOf(large, small) > kNear) return false;
  const double step = std::min(std::abs(large.heightAt(small.center) - small.height_m),
                               std::abs(large.height_m - small.height_m));
  const double tolerance = std::max(kLevelTolerance, kLevelSigmas * one.scale.noise_m) +
                           kUnevenShare * (large.rms_m + small.rms_m);
  if (step > tolerance) return false;
  if (one.samples.size() < kYawSamples || two.samples.size() < kYawSamples) return true;
  return std::abs(geometry::foldQuarterTurn(one.yaw_rad - two.yaw_rad)) < kSameYaw;
}

/// An empty group in the memory of one before.
TopGroup& TopGroups::addGroup() {
  if (spare_.empty()) return groups_.emplace_back();
  TopGroup& made = groups_.emplace_back(std::move(spare_.back()));
  spare_.pop_back();
  made.pieces.clear();
  made.dents.clear();
  made.samples.clear();
  made.box = PixelBox();
  return made;
}

const std::vector<TopGroup>& TopGroups::find(const BaseCloud& cloud, const CellGrid& cells,
                                             const SensorNoise& noise, const LevelPieces& pieces) {
  const std::size_t count = pieces.pieces().size();
  if (outlines_.size() < count) outlines_.resize(count);
  std::vector<std::size_t>& group = first_;
  group.resize(count);
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (std::size_t i = 0; i < count; ++i) trace(cloud, cells, noise, pieces, i);
  findDents(cells, pieces);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 1; k < count; ++k) {
      if (group[i] == group[k] || !together(pieces, i, k)) continue;
      const std::size_t from = std::max(group[i], group[k]);
      const std::size_t to = std::min(group[i], group[k]);
      std::replace(group.begin(), group.end(), from, to);
    }
  }
  for (TopGroup& before : groups_) spare_.push_back(std::move(before));
  groups_.clear();
  for (std::size_t first = 0; first < count; ++first) {
    if (group[first] != first || !outlines_[first].usable) continue;
    TopGroup& made = addGroup();
    std::size_t most = 0;
    for (std::size_t i = first; i < count; ++i) {
      if (group[i] != first || !outlines_[i].usable) continue;
      const Outline& outline = outlines_[i];
      made.pieces.push_back(static_cast<int>(i));
      for (std::size_t k = 0; k < count; ++k) {
        if (outlines_[k].dent_of == i) made.dents.push_back(static_cast<int>(k));
      }
      made.box.include(outline.box);
      made.samples.insert(made.samples.end(), outline.samples.begin(), outline.samples.end());
      if (pieces.pieces()[i].points <= most) continue;
      most = pieces.pieces()[i].points;
      made.largest = static_cast<int>(i);
      made.scale = outline.scale;
      made.pixel_m = outline.pixel_m;
      made.yaw_rad = outline.yaw_rad;
      made.rays = outline.rays;
    }
    if (made.pieces.size() > 1) {
      made.rays.fit(cloud, made.box.grown(kRayMargin, cloud.width(), cloud.height()));
      made.yaw_rad = sharpestYaw(made.samples, made.pixel_m, lines_);
    }
  }
  return groups_;
}

}  // namespace mixed_palletizing::detection
