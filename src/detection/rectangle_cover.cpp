#include "rectangle_cover.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

constexpr double kSameLine = 0.0012;     // [m] lines nearer than this (or a pixel) are one
constexpr double kOnLine = 0.0015;       // [m] samples this near (or a pixel) support a line
constexpr double kFreeShare = 0.03;      // of a rectangle: places looked past
constexpr double kLeastTopShare = 0.25;  // of a rectangle
constexpr double kBoxPrice = 0.10;       // [m] of supported outline that another box must bring
constexpr double kCutPrice = 0.5;        // per metre of side that runs through the surface without a seam
constexpr double kLoosePrice = 0.5;    // per metre of side with surface inside, none outside, and no outline
constexpr double kUnknownGain = 0.02;  // per metre of side that cannot be seen
constexpr double kUnknownPrice = 3.0;  // per square metre that cannot be seen
constexpr double kAreaGain = 20.0;     // per square metre of surface that is explained
constexpr double kWidestBand = 0.08;   // [m]
constexpr double kSurfaceBeyond = 0.05;  // share of that strip
constexpr std::size_t kMaxCandidates = 48;
constexpr std::size_t kMaxBoxes = 6;
constexpr std::size_t kMaxLines = 14;  // per axis

bool overlap(const LocalBox& a, const LocalBox& b) {
  const Eigen::Array2d shared = a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low);
  return (shared > 0.004).all();
}

LocalBox shrunk(const LocalBox& box, double by) { return {box.low.array() + by, box.high.array() - by}; }

}  // namespace

RectangleCover::Support& RectangleCover::SupportLines::add(double at_m) {
  if (count == kept.size()) kept.emplace_back();
  Support& line = kept[count++];
  line.at_m = at_m;
  return line;
}

void RectangleCover::prepareLines(const TopGroup& group, const TopAxes& axes, const OutlineLines& lines,
                                  const std::vector<Seam>& seams, const TopRaster& raster) {
  bounds_ = raster.bounds();
  pitch_m_ = raster.pitch();
  const double same = std::max(kSameLine, group.pixel_m);
  const double near = std::max(kOnLine, 1.5 * group.pixel_m);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    auto& places = places_;
    places.clear();
    for (const OutlineLine& line : lines[axis]) places.emplace_back(line.length_m, line.at_m);
    for (const Seam& seam : seams) {
      if (seam.axis == static_cast<int>(axis)) places.emplace_back(seam.to_m - seam.from_m, seam.at_m);
    }
    // Where the visible surface ends, for sides that nothing shows.
    double low = INFINITY;
    double high = -INFINITY;
    for (const EdgeSample& s : group.samples) {
      const double at = axes.local(s.place)(static_cast<Eigen::Index>(axis));
      low = std::min(low, at);
      high = std::max(high, at);
    }
    places.emplace_back(0.0, low);
    places.emplace_back(0.0, high);
    std::sort(places.rbegin(), places.rend());
    lines_[axis].count = 0;
    for (const auto& place : places) {
      const bool taken = std::any_of(lines_[axis].begin(), lines_[axis].end(), [&](const Support& other) {
        return std::abs(other.at_m - place.second) < (place.first > 0.0 ? same : 2.0 * near);
      });
      if (taken || lines_[axis].count >= kMaxLines) continue;
      lines_[axis].add(place.second);
    }
    const auto other = static_cast<Eigen::Index>(1 - axis);
    const auto bins = static_cast<std::size_t>(bounds_.size()(other) / pitch_m_) + 2;
    for (Support& line : lines_[axis]) {
      for (auto& sums : line.sums) sums.assign(bins + 1, 0.0f);
    }
    const auto binOf = [&](double along) {
      return static_cast<std::size_t>(
          std::clamp((along - bounds_.low(other)) / pitch_m_, 0.0, static_cast<double>(bins - 1)));
    };
    for (const EdgeSample& s : group.samples) {
      const bool seam = s.beyond == Beyond::kHole && static_cast<double>(s.gap_m) < kWideSeam;
      if (!s.isEdge() && !seam) continue;
      const double cosine = s.outward.dot(axis == 0 ? axes.u : axes.v);
      if (std::abs(cosine) < 0.5) continue;
      const Eigen::Vector2d local = axes.local(s.place);
      for (Support& line : lines_[axis]) {
        if (std::abs(local(static_cast<Eigen::Index>(axis)) - line.at_m) > near) continue;
        const std::size_t bin = binOf(local(other));
        if (s.soft && surfaceBeyond(raster, line.at_m, bin, axis, cosine > 0.0)) continue;
        line.sums[cosine < 0.0 ? 0u : 1u][bin + 1] = 1.0f;
      }
    }
    for (const Seam& seam : seams) {
      if (seam.axis != static_cast<int>(axis)) continue;
      for (Support& line : lines_[axis]) {
        if (std::abs(seam.at_m - line.at_m) > near) continue;
        for (std::size_t b = binOf(seam.from_m); b <= binOf(seam.to_m); ++b) {
          line.sums[0][b + 1] = line.sums[1][b + 1] = 1.0f;
        }
      }
    }
    for (Support& line : lines_[axis]) {
      for (auto& sums : line.sums) {
        for (std::size_t b = 1; b < sums.size(); ++b) sums[b] = sums[b - 1] + sums[b];
      }
    }
    std::sort(lines_[axis].begin(), lines_[axis].end(),
              [](const Support& a, const Support& b) { return a.at_m < b.at_m; });
  }
}

double RectangleCover::supported(const Support& line, std::size_t axis, std::size_t kind, double from,
                                 double to) const {
  const auto other = static_cast<Eigen::Index>(1 - axis);
  const std::vector<float>& sums = line.sums[kind];
  const double most = static_cast<double>(sums.size() - 1);
  const auto a = static_cast<std::size_t>(std::clamp((from - bounds_.low(other)) / pitch_m_, 0.0, most));
  const auto b = static_cast<std::size_t>(std::clamp((to - bounds_.low(other)) / pitch_m_, 0.0, most));
  return b > a ? pitch_m_ * static_cast<double>(sums[b] - sums[a]) : 0.0;
}

/// Whether the same surface goes on within the width of a band of dark print beyond a place of a line.
bool RectangleCover::surfaceBeyond(const TopRaster& raster, double at_m, std::size_t bin, std::size_t axis,
                                   bool high) const {
  const auto a = static_cast<Eigen::Index>(axis);
  const double along = bounds_.low(1 - a) + static_cast<double>(bin) * pitch_m_;
  LocalBox beyond;
  beyond.low(1 - a) = along;
  beyond.high(1 - a) = along + pitch_m_;
  beyond.low(a) = high ? at_m + pitch_m_ : at_m - kWidestBand;
  beyond.high(a) = high ? at_m + kWidestBand : at_m - pitch_m_;
  const TopRaster::Count count = raster.count(beyond);
  return count.top > kSurfaceBeyond * count.all;
}

/// Fills support and score; false when the rectangle cannot be a top.
bool RectangleCover::rate(const TopRaster& raster, const std::array<const Support*, 4>& sides,
                          CoverBox& candidate) const {
  const LocalBox& box = candidate.box;
  const TopRaster::Count inner = raster.count(shrunk(box, pitch_m_));
  if (inner.all == 0 || inner.free > kFreeShare * inner.all + 4 || inner.top < kLeastTopShare * inner.all)
    return false;
  candidate.score = -kBoxPrice;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t axis = i / 2;
    const bool high = i % 2 == 1;
    const auto a = static_cast<Eigen::Index>(axis);
    const double from = box.low(1 - a);
    const double to = box.high(1 - a);
    const double length = to - from;
    const double found = std::min(length, supported(*sides[i], axis, high ? 1 : 0, from, to));
    candidate.support[i] = found / length;
    // A strip on either side of the side.
    const double at = sides[i]->at_m;
    LocalBox in = box;
    LocalBox out = box;
    (high ? in.low : in.high)(a) = at + (high ? -2.5 : 2.5) * pitch_m_;
    (high ? in.high : in.low)(a) = at + (high ? -1.0 : 1.0) * pitch_m_;
    (high ? out.low : out.high)(a) = at + (high ? 1.0 : -1.0) * pitch_m_;
    (high ? out.high : out.low)(a) = at + (high ? 2.5 : -2.5) * pitch_m_;
    const TopRaster::Count inside = raster.count(in);
    const TopRaster::Count outside = raster.count(out);
    const double in_top = inside.all > 0 ? static_cast<double>(inside.top) / inside.all : 0.0;
    const double out_top = outside.all > 0 ? static_cast<double>(outside.top) / outside.all : 0.0;
    const double out_free = outside.all > 0 ? static_cast<double>(outside.free) / outside.all : 0.0;
    const double rest = length - found;
    const double cut = std::min(rest, std::min(in_top, out_top) * length);
    candidate.cut[i] = cut / length;
    const double loose = std::min(rest - cut, std::max(0.0, std::min(in_top, out_free) * length - found));
    candidate.score += found - kCutPrice * cut - kLoosePrice * std::max(0.0, loose) +
                       kUnknownGain * std::max(0.0, rest - cut - std::max(0.0, loose));
  }
  candidate.score += (kAreaGain * inner.top - kUnknownPrice * inner.unknown()) * pitch_m_ * pitch_m_;
  return true;
}

void RectangleCover::collect(const TopRaster& raster, const CoverOptions& options) {
  candidates_.clear();
  const auto fits = [&](double size) { return size >= options.min_side_m && size <= options.max_side_m; };
  for (Support& left : lines_[0]) {
    for (Support& right : lines_[0]) {
      if (!fits(right.at_m - left.at_m)) continue;
      for (Support& bottom : lines_[1]) {
        for (Support& top : lines_[1]) {
          if (!fits(top.at_m - bottom.at_m)) continue;
          CoverBox candidate;
          candidate.box = {{left.at_m, bottom.at_m}, {right.at_m, top.at_m}};
          if (rate(raster, {&left, &right, &bottom, &top}, candidate)) candidates_.push_back(candidate);
        }
      }
    }
  }
  std::sort(candidates_.begin(), candidates_.end(),
            [](const CoverBox& a, const CoverBox& b) { return a.score > b.score; });
  if (candidates_.size() > kMaxCandidates) candidates_.resize(kMaxCandidates);
}

/// Tries every set of disjoint candidates, in their order.
void RectangleCover::choose(const TopRaster& raster, std::size_t next, double score) {
  if (score > best_score_) {
    best_score_ = score;
    best_ = chosen_;
  }
  if (chosen_.size() == kMaxBoxes) return;
  for (std::size_t i = next; i < candidates_.size(); ++i) {
    const double left = static_cast<double>(kMaxBoxes - chosen_.size());
    if (score + left * candidates_[i].score <= best_score_) return;  // the rest is no better
    if (candidates_[i].score <= 0.0) return;
    const bool free = std::none_of(chosen_.begin(), chosen_.end(), [&](std::size_t other) {
      return overlap(candidates_[i].box, candidates_[other].box);
    });
    if (!free) continue;
    chosen_.push_back(i);
    choose(raster, i + 1, score + candidates_[i].score);
    chosen_.pop_back();
  }
}

const std::vector<CoverBox>& RectangleCover::find(const TopGroup& group, const TopAxes& axes,
                                                  const OutlineLines& lines, const std::vector<Seam>& seams,
                                                  const TopRaster& raster, const CoverOptions& options) {
  prepareLines(group, axes, lines, seams, raster);
  collect(raster, options);
  chosen_.clear();
  best_.clear();
  best_score_ = 0.0;
  choose(raster, 0, 0.0);
  result_.clear();
  for (const std::size_t i : best_) result_.push_back(candidates_[i]);
  return result_;
}

}  // namespace mixed_palletizing::detection
