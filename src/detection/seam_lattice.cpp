#include "seam_lattice.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

constexpr double kStepPixels = 0.7;     // between places across
constexpr int kMostLines = 64;          // along
constexpr float kDeepestSigmas = 4.0f;  // of the noise: a place without surface counts as that deep
constexpr double kLeastReach = 0.003;   // [m] around the level that is the surface
constexpr int kAhead = 12;              // places: the memory of their pixels is asked for beforehand

}  // namespace

/// Lines run askew through the image, so that the processor does not foresee what is read next.
void SeamLattice::prefetch(const geometry::CloudView& view, int i) const {
  const auto at = static_cast<std::size_t>(i);
  if (cols_[at] >= 0) __builtin_prefetch(view.at(rows_[at], cols_[at]));
}

void SeamLattice::look(const BaseCloud& cloud, const LevelPieces& pieces, const TopGroup& group,
                       const TopAxes& axes, const LocalBox& bounds, int axis) {
  const LevelPiece& piece = pieces.pieces()[static_cast<std::size_t>(group.largest)];
  const LevelMap map = mapOf(piece, group.rays, axes);
  const double level = piece.heightAt(axes.origin);
  const double slope_u = piece.slope.dot(axes.u);
  const double slope_v = piece.slope.dot(axes.v);
  const Eigen::Index a = axis;
  step_m_ = kStepPixels * group.pixel_m;
  line_step_m_ = std::max(1.5 * group.pixel_m, bounds.size()(1 - a) / kMostLines);
  from_m_ = bounds.low(a);
  line_from_m_ = bounds.low(1 - a) + 0.5 * line_step_m_;
  count_ = static_cast<int>(bounds.size()(a) / step_m_);
  lines_ = static_cast<int>(bounds.size()(1 - a) / line_step_m_);
  tops_.assign(start(lines_), 0);
  heights_.assign(start(lines_), 0.0f);
  for (auto& channel : colors_) channel.assign(start(lines_), 0);
  for (auto& places : places_) places.resize(static_cast<std::size_t>(count_));
  cols_.resize(static_cast<std::size_t>(count_));
  rows_.resize(static_cast<std::size_t>(count_));
  const bool colored = cloud.view().hasColor();
  const float reach = static_cast<float>(std::max(2.0 * group.scale.band_m, kLeastReach));
  const float deepest = kDeepestSigmas * static_cast<float>(group.scale.noise_m);
  std::vector<float>& along = places_[static_cast<std::size_t>(1 - axis)];
  for (std::size_t i = 0; i < cols_.size(); ++i) {
    places_[static_cast<std::size_t>(axis)][i] = static_cast<float>(across(static_cast<double>(i)));
  }
  for (int line = 0; line < lines_; ++line) {
    Eigen::Vector2d local;
    local(1 - a) = line_from_m_ + line * line_step_m_;
    std::fill(along.begin(), along.end(), static_cast<float>(local(1 - a)));
    map.pixels(places_[0].data(), places_[1].data(), cols_.size(), cloud.width(), cloud.height(),
               cols_.data(), rows_.data());
    std::size_t at = start(line);
    for (int i = 0; i < count_; ++i, ++at) {
      const int row = rows_[static_cast<std::size_t>(i)];
      const int col = cols_[static_cast<std::size_t>(i)];
      if (i + kAhead < count_) prefetch(cloud.view(), i + kAhead);
      if (col < 0) continue;
      heights_[at] = -deepest;
      if (!cloud.valid(row, col)) continue;
      local(a) = across(i);
      const float off =
          cloud.point(row, col).z() - static_cast<float>(level + slope_u * local.x() + slope_v * local.y());
      heights_[at] = std::clamp(off, -deepest, deepest);
      if (!(std::abs(off) < reach)) continue;
      tops_[at] = 1;
      if (!colored) continue;
      const std::uint8_t* bgr = cloud.view().bgr(row, col);
      for (std::size_t k = 0; k < 3; ++k) colors_[k][at] = bgr[k];
    }
  }
}

double SeamLattice::colorNoise() const {
  std::array<int, 256> counts{};
  int all = 0;
  for (int line = 0; line < lines_; line += 3) {
    const std::uint8_t* top = tops(line);
    const std::uint8_t* color = colors(line, 1);
    for (int i = 0; i + 4 < count_; i += 3) {
      if (top[i] == 0 || top[i + 4] == 0) continue;
      ++counts[static_cast<std::size_t>(std::abs(color[i] - color[i + 4]))];
      ++all;
    }
  }
  int below = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    below += counts[k];
    if (2 * below >= all) return static_cast<double>(k);
  }
  return 0.0;
}

}  // namespace mixed_palletizing::detection
