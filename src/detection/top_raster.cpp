#include "top_raster.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

constexpr double kPitch = 0.002;  // [m]
constexpr double kPitchPixels = 1.3;
constexpr double kMargin = 0.012;  // [m] around the samples
constexpr int kMaxPlaces = 400;    // per side

}  // namespace

LevelMap mapOf(const LevelPiece& level, const RayModel& rays, const TopAxes& axes) {
  const Eigen::Vector3d origin(axes.origin.x(), axes.origin.y(), level.heightAt(axes.origin));
  const Eigen::Vector3d u(axes.u.x(), axes.u.y(), level.slope.dot(axes.u));
  const Eigen::Vector3d v(axes.v.x(), axes.v.y(), level.slope.dot(axes.v));
  return rays.levelMap(origin, u, v);
}

void TopRaster::fill(const BaseCloud& cloud, const CellGrid& cells, const LevelPieces& pieces,
                     const TopGroup& group, const TopAxes& axes) {
  bounds_ = LocalBox::none();
  for (const EdgeSample& s : group.samples) bounds_.include(axes.local(s.place));
  pitch_m_ = std::max(kPitch, kPitchPixels * group.pixel_m);
  const double margin = std::max(kMargin, 3.0 * pitch_m_);
  bounds_.low.array() -= margin;
  bounds_.high.array() += margin;
  pitch_m_ = std::max(pitch_m_, bounds_.size().maxCoeff() / kMaxPlaces);
  cols_ = static_cast<int>(std::ceil(bounds_.size().x() / pitch_m_));
  rows_ = static_cast<int>(std::ceil(bounds_.size().y() / pitch_m_));
  member_.assign(pieces.pieces().size(), 0);
  for (const int piece : group.pieces) member_[static_cast<std::size_t>(piece)] = 1;
  for (const int piece : group.dents) member_[static_cast<std::size_t>(piece)] = 1;
  top_.assign(at(0, rows_ + 1), 0);
  free_.assign(top_.size(), 0);
  const LevelPiece& level = pieces.pieces()[static_cast<std::size_t>(group.largest)];
  const LevelMap map = mapOf(level, group.rays, axes);
  for (int k = 0; k < rows_; ++k) {
    int top = 0;
    int free = 0;
    for (int i = 0; i < cols_; ++i) {
      const Eigen::Vector2d local = bounds_.low + pitch_m_ * Eigen::Vector2d(i + 0.5, k + 0.5);
      int row = 0;
      int col = 0;
      Seen seen = Seen::kUnknown;
      if (map.pixel(static_cast<float>(local.x()), static_cast<float>(local.y()), cloud.width(),
                    cloud.height(), col, row)) {
        seen = look(cloud, cells, pieces, group, row, col, level.heightAt(axes.place(local)));
      }
      top += seen == Seen::kTop ? 1 : 0;
      free += seen == Seen::kFree ? 1 : 0;
      top_[at(i + 1, k + 1)] = top_[at(i + 1, k)] + top;
      free_[at(i + 1, k + 1)] = free_[at(i + 1, k)] + free;
    }
  }
}

Seen TopRaster::look(const BaseCloud& cloud, const CellGrid& cells, const LevelPieces& pieces,
                     const TopGroup& group, int row, int col, double level) const {
  const int piece = pieces.pieceOf(cells.index(row / cells.cellPx(), col / cells.cellPx()));
  if (piece >= 0 && member_[static_cast<std::size_t>(piece)]) return Seen::kTop;
  if (!cloud.valid(row, col)) return Seen::kUnknown;
  const double off = static_cast<double>(cloud.point(row, col).z()) - level;
  const auto points = [&](int i) {
    return static_cast<double>(pieces.pieces()[static_cast<std::size_t>(i)].points);
  };
  const bool other = piece >= 0 && points(piece) >= kDentShare * points(group.largest);
  // A large piece of another group is the top of something else, even at the same level.
  if (std::abs(off) <= group.scale.band_m) return other ? Seen::kUnknown : Seen::kTop;
  if (off > 0.0) return Seen::kUnknown;
  if (off < -std::max(kDeepestDent, 2.0 * group.scale.band_m)) return Seen::kFree;
  return other ? Seen::kFree : Seen::kUnknown;
}

TopRaster::Count TopRaster::count(const LocalBox& box) const {
  const Eigen::Array2d low = ((box.low - bounds_.low) / pitch_m_).array().round();
  const Eigen::Array2d high = ((box.high - bounds_.low) / pitch_m_).array().round();
  const int i0 = std::clamp(static_cast<int>(low.x()), 0, cols_);
  const int i1 = std::clamp(static_cast<int>(high.x()), 0, cols_);
  const int k0 = std::clamp(static_cast<int>(low.y()), 0, rows_);
  const int k1 = std::clamp(static_cast<int>(high.y()), 0, rows_);
  Count count;
  if (i1 <= i0 || k1 <= k0) return count;
  count.all = (i1 - i0) * (k1 - k0);
  count.top = top_[at(i1, k1)] - top_[at(i0, k1)] - top_[at(i1, k0)] + top_[at(i0, k0)];
  count.free = free_[at(i1, k1)] - free_[at(i0, k1)] - free_[at(i1, k0)] + free_[at(i0, k0)];
  return count;
}

}  // namespace mixed_palletizing::detection
