#include "seam_search.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

constexpr double kStepPixels = 0.7;      // between places across
constexpr int kMostLines = 64;           // along
constexpr int kNear = 2;                 // places next to a seam that may belong to it
constexpr int kWindow = 5;               // places beyond these that show one side
constexpr float kLeastSeen = 3.0f;       // of a window
constexpr float kDeepestSigmas = 4.0f;   // of the noise: a place without surface counts as that deep
constexpr double kLeastColorStep = 4.0;  // of 255
constexpr double kColorSigmas = 4.0;
constexpr double kLeastDip = 0.00015;  // [m] mean along the seam
constexpr double kUnevenDip = 0.001;   // [m] the same on an uneven surface
constexpr double kDipSigmas = 7.0;
constexpr int kParts = 4;              // of a seam: a dent dips in one of them only
constexpr double kPartShare = 0.3;     // of the mean dip that every part must show, less its noise
constexpr double kColorShare = 0.8;    // of a seam's lines that must show the step
constexpr double kInsideShare = 0.75;  // of a stretch's lines that have surface on both sides
constexpr double kEndFrom = 0.004;     // [m] behind the end of a change of colour ...
constexpr double kEndTo = 0.010;       // ... and up to here there is no surface
constexpr double kEndAtSeam = 0.003;   // [m] or a seam runs across this near
constexpr double kFar = 0.02;          // [m] to both sides of a seam there must be surface
constexpr int kFarSamples = 5;
constexpr double kShortest = 0.015;  // [m]
constexpr double kMargin = 0.004;    // [m] at the ends of a stretch that may be torn

}  // namespace

void SeamSearch::sample(const BaseCloud& cloud, const LevelPieces& pieces, const TopGroup& group,
                        const TopAxes& axes, const LocalBox& bounds, int axis) {
  const LevelPiece& piece = pieces.pieces()[static_cast<std::size_t>(group.largest)];
  const LevelMap map = mapOf(piece, group.rays, axes);
  const double start = piece.heightAt(axes.origin);
  const double slope_u = piece.slope.dot(axes.u);
  const double slope_v = piece.slope.dot(axes.v);
  const Eigen::Index a = axis;
  step_m_ = kStepPixels * group.pixel_m;
  line_step_m_ = std::max(1.5 * group.pixel_m, bounds.size()(1 - a) / kMostLines);
  from_m_ = bounds.low(a);
  line_from_m_ = bounds.low(1 - a) + 0.5 * line_step_m_;
  count_ = static_cast<int>(bounds.size()(a) / step_m_);
  lines_ = static_cast<int>(bounds.size()(1 - a) / line_step_m_);
  spots_.assign(static_cast<std::size_t>(count_) * static_cast<std::size_t>(lines_), Spot{});
  const bool colored = cloud.view().hasColor();
  const float reach = static_cast<float>(std::max(2.0 * group.scale.band_m, 0.003));
  const float deepest = kDeepestSigmas * static_cast<float>(group.scale.noise_m);
  for (int line = 0; line < lines_; ++line) {
    for (int i = 0; i < count_; ++i) {
      Eigen::Vector2d local;
      local(a) = from_m_ + (i + 0.5) * step_m_;
      local(1 - a) = line_from_m_ + line * line_step_m_;
      int col = 0;
      int row = 0;
      if (!map.pixel(static_cast<float>(local.x()), static_cast<float>(local.y()), cloud.width(),
                     cloud.height(), col, row)) {
        continue;
      }
      const double level = start + slope_u * local.x() + slope_v * local.y();
      Spot& spot = spots_[static_cast<std::size_t>(line) * static_cast<std::size_t>(count_) +
                          static_cast<std::size_t>(i)];

      spot.off = -deepest;
      if (!cloud.valid(row, col)) continue;
      const float off = cloud.point(row, col).z() - static_cast<float>(level);
      spot.off = std::clamp(off, -deepest, deepest);
      spot.top = std::abs(off) < reach;
      if (!spot.top || !colored) continue;
      const std::uint8_t* bgr = cloud.view().bgr(row, col);
      for (std::size_t k = 0; k < 3; ++k) spot.color[k] = bgr[k];
    }
  }
}

/// Spread of the colour between places that are the same but for noise.
double SeamSearch::colorNoise() const {
  std::array<int, 256> counts{};
  int all = 0;
  for (int line = 0; line < lines_; line += 3) {
    for (int i = 0; i + 4 < count_; i += 3) {
      const Spot& one = spot(line, i);
      const Spot& two = spot(line, i + 4);
      if (!one.top || !two.top) continue;
      ++counts[static_cast<std::size_t>(std::min(255, std::abs(one.color[1] - two.color[1])))];
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

/// Whether the surface reaches far enough to both sides to be two tops: beside an edge, a strip of the face below
/// passes for surface.
bool SeamSearch::wide(int line, int i) const {
  for (const int sign : {-1, 1}) {
    int top = 0;
    for (int k = 1; k <= kFarSamples; ++k) {
      const int at = i + sign * static_cast<int>(kFar / step_m_ * (0.5 + 0.5 * k / kFarSamples));
      if (at >= 0 && at < count_ && spot(line, at).top) ++top;
    }
    if (2 * top <= kFarSamples) return false;
  }
  return true;
}

/// Whether a change of colour ends there as boxes do: at the end of the surface, or at a seam across. Prints end in
/// between.
bool SeamSearch::endsAt(double along_m, int sign, int i, int axis) const {
  for (const Seam& seam : seams_) {
    if (seam.axis != axis && std::abs(seam.at_m - along_m) < kEndAtSeam) return true;
  }
  int tops = 0;
  int all = 0;
  for (double off = kEndFrom; off <= kEndTo; off += line_step_m_) {
    const int line = static_cast<int>(std::lround((along_m + sign * off - line_from_m_) / line_step_m_));
    for (const int at : {i - kNear - kWindow, i + kNear + kWindow}) {
      ++all;
      if (line >= 0 && line < lines_ && at >= 0 && at < count_ && spot(line, at).top) ++tops;
    }
  }
  return 2 * tops <= all;
}

void SeamSearch::rate(int line, double color_step) {
  for (int i = kNear + kWindow; i + kNear + kWindow < count_; ++i) {
    std::array<float, 2> off{};
    std::array<std::array<float, 3>, 2> color{};
    std::array<float, 2> seen{};
    for (int side = 0; side < 2; ++side) {
      const auto s = static_cast<std::size_t>(side);
      for (int k = kNear + 1; k <= kNear + kWindow; ++k) {
        const Spot& there = spot(line, side == 0 ? i - k : i + k);
        if (!there.top) continue;
        seen[s] += 1.0f;
        off[s] += there.off;
        for (std::size_t c = 0; c < 3; ++c) color[s][c] += static_cast<float>(there.color[c]);
      }
    }
    if (seen[0] < kLeastSeen || seen[1] < kLeastSeen || !wide(line, i)) continue;
    const auto at =
        static_cast<std::size_t>(line) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(i);
    inside_[at] = 1;
    float here = 0.0f;
    for (int k = -1; k <= 1; ++k) here += spot(line, i + k).off / 3.0f;
    dips_[at] = 0.5f * (off[0] / seen[0] + off[1] / seen[1]) - here;
    float step = 0.0f;
    for (std::size_t c = 0; c < 3; ++c) {
      step = std::max(step, std::abs(color[0][c] / seen[0] - color[1][c] / seen[1]));
    }
    steps_[at] = static_cast<double>(step) > color_step ? 1 : 0;
  }
}

void SeamSearch::findAcross(int axis, double noise_m, double least_dip, const std::vector<double>& breaks) {
  struct Peak {
    double strength = 0.0;
    int i = 0;
  };
  for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
    if (breaks[b + 1] - breaks[b] < kShortest) continue;
    const int first =
        std::max(0, static_cast<int>(std::ceil((breaks[b] + kMargin - line_from_m_) / line_step_m_)));
    const int last = std::min(
        lines_ - 1, static_cast<int>(std::floor((breaks[b + 1] - kMargin - line_from_m_) / line_step_m_)));
    if (last - first < 3) continue;
    std::vector<Peak> peaks;
    for (int i = 0; i < count_; ++i) {
      int inside = 0;
      int steps = 0;
      double dip = 0.0;
      std::array<double, kParts> part_dip{};
      std::array<int, kParts> part_inside{};
      for (int line = first; line <= last; ++line) {
        const auto at =
            static_cast<std::size_t>(line) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(i);
        if (!inside_[at]) continue;
        ++inside;
        steps += steps_[at];
        dip += static_cast<double>(dips_[at]);
        const auto part = static_cast<std::size_t>(kParts * (line - first) / (last - first + 1));
        ++part_inside[part];
        part_dip[part] += static_cast<double>(dips_[at]);
      }
      if (inside < kInsideShare * (last - first + 1)) continue;
      dip /= inside;
      const double least = std::max(least_dip, kDipSigmas * noise_m / std::sqrt(2.0 * inside));
      bool everywhere = true;
      for (std::size_t part = 0; part < kParts; ++part) {
        const double n = part_inside[part];
        everywhere = everywhere &&
                     (n == 0 || part_dip[part] / n > kPartShare * dip - 2.0 * noise_m / std::sqrt(2.0 * n));
      }
      const double by_dip = everywhere ? dip / least : 0.0;
      double by_color = static_cast<double>(steps) / (kColorShare * inside);
      if (by_color > 1.0 && !(endsAt(breaks[b], -1, i, axis) && endsAt(breaks[b + 1], 1, i, axis)))
        by_color = 0.0;
      const double strength = std::max(by_dip, by_color);
      if (strength > 1.0) peaks.push_back({strength + 0.01 * by_dip, i});
    }
    // A seam is seen by a few places side by side: their middle, by strength.
    for (std::size_t p = 0; p < peaks.size();) {
      std::size_t end = p + 1;
      while (end < peaks.size() && peaks[end].i - peaks[end - 1].i <= 2) ++end;
      double best = 0.0;
      for (std::size_t k = p; k < end; ++k) best = std::max(best, peaks[k].strength);
      double sum = 0.0;
      double weight = 0.0;
      for (std::size_t k = p; k < end; ++k) {
        if (peaks[k].strength < 0.9 * best) continue;
        sum += peaks[k].i;
        weight += 1.0;
      }
      seams_.push_back({axis, from_m_ + (sum / weight + 0.5) * step_m_, breaks[b], breaks[b + 1]});
      p = end;
    }
  }
}

const std::vector<Seam>& SeamSearch::find(const BaseCloud& cloud, const LevelPieces& pieces,
                                          const TopGroup& group, const TopAxes& axes,
                                          const OutlineLines& lines, const LocalBox& bounds) {
  seams_.clear();
  for (int axis = 0; axis < 2; ++axis) {
    sample(cloud, pieces, group, axes, bounds, axis);
    dips_.assign(spots_.size(), 0.0f);
    inside_.assign(spots_.size(), 0);
    steps_.assign(spots_.size(), 0);
    const double color_step = std::max(kLeastColorStep, kColorSigmas * colorNoise());
    for (int line = 0; line < lines_; ++line) rate(line, color_step);
    std::vector<double> breaks;
    for (const OutlineLine& line : lines[static_cast<std::size_t>(1 - axis)]) breaks.push_back(line.at_m);
    for (const Seam& seam : seams_) {
      if (seam.axis != axis) breaks.push_back(seam.at_m);
    }
    std::sort(breaks.begin(), breaks.end());
    findAcross(axis, group.scale.noise_m, group.scale.flat ? kLeastDip : kUnevenDip, breaks);
  }
  return seams_;
}

}  // namespace mixed_palletizing::detection
