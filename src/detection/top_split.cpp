#include "top_split.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace mixed_palletizing::detection {
namespace {

constexpr double kSeamHalf_m = 0.008;  // a seam is narrower than twice this
constexpr double kGapHalf_m = 0.012;   // and so is a gap without data
constexpr double kDarkShare = 0.06;    // of the top's brightness: a line that much darker is a seam for sure
constexpr float kDarkLeast = 6.0f;     // grey values
constexpr float kOtherThing = 0.25f;   // step of brightness that print seldom makes from side to side
constexpr float kOtherThingRange = 0.1f;  // beyond that, until it is a seam for sure
constexpr double kNoDataEvidence = 0.3;   // of a wide place without data: a dark band runs across tops too
constexpr int kSlopes = 6;                // to each side
constexpr double kSlopeStep = 0.0175;     // 1 degree
constexpr double kFilled = 0.25;          // share of a row or column of a part that is top: less is outside
constexpr double kLeastPart = 0.5;        // of the smallest box's area
constexpr int kMostCuts = 200;
constexpr int kCutParts = 4;          // of a cut: a label shows no seam in one of them at least
constexpr double kLeastOfPart = 0.3;  // evidence

double at(const PartSide& side, double along) { return side.offset + side.slope * along; }

bool inside(const TopPart& part, double u, double v) {
  return v > at(part[0], u) && v < at(part[2], u) && u < at(part[1], v) && u > at(part[3], v);
}

/// Bounds of a part in cells of the picture.
struct Bounds {
  int u_low, u_high, v_low, v_high;
};

Bounds boundsOf(const TopPicture& picture, const TopPart& part) {
  const double u_end = picture.cols();
  const double v_end = picture.rows();
  const auto range = [](double a, double b, double end, bool low) {
    return static_cast<int>(std::clamp(low ? std::min(a, b) : std::max(a, b) + 1.0, 0.0, end));
  };
  Bounds b{};
  b.v_low = range(at(part[0], 0), at(part[0], u_end), v_end, true);
  b.v_high = range(at(part[2], 0), at(part[2], u_end), v_end, false);
  b.u_low = range(at(part[3], 0), at(part[3], v_end), u_end, true);
  b.u_high = range(at(part[1], 0), at(part[1], v_end), u_end, false);
  return b;
}

/// Moves the sides that are no seams inwards to where the part begins to be filled with top.
void trim(const TopPicture& picture, TopPart& part) {
  const Bounds b = boundsOf(picture, part);
  std::vector<int> by_u(static_cast<std::size_t>(picture.cols()), 0);
  std::vector<int> by_v(static_cast<std::size_t>(picture.rows()), 0);
  for (int v = b.v_low; v < b.v_high; ++v) {
    for (int u = b.u_low; u < b.u_high; ++u) {
      if (!picture.isTop(u, v) || !inside(part, u, v)) continue;
      ++by_u[static_cast<std::size_t>(u)];
      ++by_v[static_cast<std::size_t>(v)];
    }
  }
  const auto ends = [](const std::vector<int>& counts, double needed) {
    int first = -1, last = -1;
    for (int i = 0; i < static_cast<int>(counts.size()); ++i) {
      if (counts[static_cast<std::size_t>(i)] <= needed) continue;
      if (first < 0) first = i;
      last = i;
    }
    return std::make_pair(first, last);
  };
  const auto most = [](const std::vector<int>& counts) {
    return *std::max_element(counts.begin(), counts.end());
  };
  const auto [u_first, u_last] = ends(by_u, kFilled * most(by_u));
  const auto [v_first, v_last] = ends(by_v, kFilled * most(by_v));
  if (!part[0].seam) part[0] = {v_first - 0.5, 0.0, false};
  if (!part[2].seam) part[2] = {v_last + 0.5, 0.0, false};
  if (!part[3].seam) part[3] = {u_first - 0.5, 0.0, false};
  if (!part[1].seam) part[1] = {u_last + 0.5, 0.0, false};
}

struct Cut {
  bool upright = true;  // along v, across u
  PartSide line;
  double evidence = 0.0;
};

/// Mean evidence along a line through a part; nothing when too little of the line lies in it, or when the evidence does
/// not run from end to end.
double evidenceAlong(const TopPicture& picture, const TopPart& part, const Bounds& b, const Cut& cut) {
  const int begin = cut.upright ? b.v_low : b.u_low;
  const int end = cut.upright ? b.v_high : b.u_high;
  std::array<double, kCutParts> sums{};
  std::array<int, kCutParts> counts{};
  for (int along = begin; along < end; ++along) {
    const double across = at(cut.line, along);
    const double u = cut.upright ? across : along;
    const double v = cut.upright ? along : across;
    if (!inside(part, u, v)) continue;
    const auto k = static_cast<std::size_t>(kCutParts * (along - begin) / (end - begin));
    sums[k] += seamEvidence(picture, u, v, cut.upright);
    ++counts[k];
  }
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    if (sums[k] < kLeastOfPart * counts[k]) return 0.0;
    sum += sums[k];
    count += counts[k];
  }
  return 2 * count > end - begin ? sum / count : 0.0;
}

std::optional<Cut> bestCut(const TopPicture& picture, const TopPart& part, const SplitLimits& limits) {
  const Bounds b = boundsOf(picture, part);
  const double least = limits.min_side_m / picture.cell();
  Cut best;
  for (const bool upright : {true, false}) {
    const int low = upright ? b.u_low : b.v_low;
    const int high = upright ? b.u_high : b.v_high;
    const double middle = upright ? 0.5 * (b.v_low + b.v_high) : 0.5 * (b.u_low + b.u_high);
    for (double across = low + least; across <= high - least; across += 1.0) {
      for (int k = -kSlopes; k <= kSlopes; ++k) {
        Cut cut;
        cut.upright = upright;
        cut.line.slope = k * kSlopeStep;
        cut.line.offset = across - cut.line.slope * middle;
        cut.line.seam = true;
        cut.evidence = evidenceAlong(picture, part, b, cut);
        if (cut.evidence > best.evidence) best = cut;
      }
    }
  }
  if (best.evidence < limits.min_evidence) return std::nullopt;
  return best;
}

double areaOf(const TopPicture& picture, const TopPart& part) {
  const Bounds b = boundsOf(picture, part);
  int count = 0;
  for (int v = b.v_low; v < b.v_high; ++v) {
    for (int u = b.u_low; u < b.u_high; ++u) count += picture.isTop(u, v) && inside(part, u, v) ? 1 : 0;
  }
  return count * picture.cell() * picture.cell();
}

}  // namespace

double seamEvidence(const TopPicture& picture, double u, double v, bool upright) {
  const int col = static_cast<int>(std::lround(u));
  const int row = static_cast<int>(std::lround(v));
  if (!picture.holds(col, row)) return 1.0;
  const auto beside = [&](int cells, int side) {
    return std::make_pair(upright ? col + side * cells : col, upright ? row : row + side * cells);
  };
  if (picture.kind(col, row) == TopCell::kNoData) {
    const int half = std::max(1, static_cast<int>(std::lround(kGapHalf_m / picture.cell())));
    const auto [u0, v0] = beside(half, -1);
    const auto [u1, v1] = beside(half, 1);
    return picture.isTop(u0, v0) && picture.isTop(u1, v1) ? 1.0 : kNoDataEvidence;
  }
  if (picture.kind(col, row) != TopCell::kTop) return 1.0;
  const int half = std::max(2, static_cast<int>(std::lround(kSeamHalf_m / picture.cell())));
  float here = picture.gray(col, row);
  for (const int side : {-1, 1}) {
    const auto [un, vn] = beside(1, side);
    if (picture.isTop(un, vn)) here = std::min(here, picture.gray(un, vn));
  }
  float sides[2] = {here, here};
  for (int k = 0; k < 2; ++k) {
    const auto [ub, vb] = beside(half, k == 0 ? -1 : 1);
    if (!picture.isTop(ub, vb)) return 0.0;  // the border of the surface, not a seam in it
    sides[k] = picture.gray(ub, vb);
  }
  const float dark = std::min(sides[0], sides[1]) - here;
  const float sure = std::max(kDarkLeast, static_cast<float>(kDarkShare) * picture.medianGray());
  const float contrast = std::abs(sides[0] - sides[1]) / std::max(1.0f, picture.medianGray());
  const float other_thing = (contrast - kOtherThing) / kOtherThingRange;
  return static_cast<double>(std::clamp(std::max(dark / sure, other_thing), 0.0f, 1.0f));
}

std::vector<TopPart> splitTop(const TopPicture& picture, const SplitLimits& limits) {
  TopPart all;
  all[0] = {-0.5, 0.0, false};
  all[1] = {picture.cols() - 0.5, 0.0, false};
  all[2] = {picture.rows() - 0.5, 0.0, false};
  all[3] = {-0.5, 0.0, false};
  std::vector<TopPart> open{all};
  std::vector<TopPart> done;
  const double least_area = kLeastPart * limits.min_side_m * limits.min_side_m;
  for (int cuts = 0; !open.empty() && cuts < kMostCuts; ++cuts) {
    TopPart part = open.back();
    open.pop_back();
    if (areaOf(picture, part) < least_area) continue;
    trim(picture, part);
    const auto cut = bestCut(picture, part, limits);
    if (!cut) {
      done.push_back(part);
      continue;
    }
    TopPart low = part;
    TopPart high = part;
    low[cut->upright ? 1 : 2] = cut->line;
    high[cut->upright ? 3 : 0] = cut->line;
    open.push_back(low);
    open.push_back(high);
  }
  return done;
}

}  // namespace mixed_palletizing::detection
