#include "side_votes.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>

#include "rectangle_sides.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr std::size_t kMinSamples = 8;  // of a side
constexpr int kBins = 20;               // along a side, to see how much of it has samples
constexpr int kMinBins = 4;
constexpr double kAcross = 0.3;        // cosine between a walk and the normal of the side that it ends at
constexpr double kCornerShare = 0.03;  // of a side: rounded corners and pixels of two sides stay out

struct Extent {
  int low = INT_MAX;
  int high = INT_MIN;
  void add(int value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  int length() const { return low > high ? 0 : high - low; }
};

}  // namespace

void collectVotes(const std::vector<EdgeSample>& samples, const geometry::Rectangle& r, std::size_t side,
                  double gate_m, double corner_m, SideVotes& result) {
  result.votes.clear();
  result.wall_share = 0.0;
  const double reach = std::max(0.0, halfAlong(r, side) * (1.0 - kCornerShare) - corner_m);
  const double offset = halfAcross(r, side);
  const Axes axes(r);
  const Eigen::Vector2d normal = kOutward[side].x() * axes.x + kOutward[side].y() * axes.y;
  const auto near = [&](const EdgeSample& sample, Vote& vote) {
    const bool seam = sample.beyond == Beyond::kHole && static_cast<double>(sample.gap_m) < kWideSeam;
    if (!sample.isEdge() && !seam) return false;
    if (sample.outward.dot(normal) < kAcross) return false;
    const Eigen::Vector2d local = axes.local(sample.place);
    vote.across = kOutward[side].dot(local);
    vote.along = alongOf(side).dot(local);
    vote.pixel = static_cast<double>(sample.pixel_m) * sample.outward.dot(normal);
    return std::abs(vote.along) < reach && std::abs(vote.across - offset) < gate_m;
  };
  Vote vote;
  Extent rows;
  Extent cols;
  std::size_t along_rows = 0;
  std::size_t along_cols = 0;
  for (const EdgeSample& sample : samples) {
    if (!near(sample, vote)) continue;
    rows.add(sample.row);
    cols.add(sample.col);
    ++(sample.along_row ? along_rows : along_cols);
  }
  const bool by_rows = rows.length() >= cols.length();
  Extent crossed;
  result.votes.reserve(by_rows ? along_rows : along_cols);
  for (const EdgeSample& sample : samples) {
    if (sample.along_row != by_rows || !near(sample, vote)) continue;
    result.votes.push_back(vote);
    if (sample.beyond == Beyond::kWall) result.wall_share += 1.0;
    crossed.add(by_rows ? sample.col : sample.row);
  }
  result.wall_share /= std::max(1.0, static_cast<double>(result.votes.size()));
  result.crossings = crossed.length();
}

bool enoughVotes(const SideVotes& side, double half_along_m) {
  if (side.votes.size() < kMinSamples) return false;
  std::array<bool, kBins> filled{};
  for (const Vote& vote : side.votes) {
    const int bin = static_cast<int>((vote.along / half_along_m + 1.0) * 0.5 * kBins);
    filled[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))] = true;
  }
  return std::count(filled.begin(), filled.end(), true) >= kMinBins;
}

double meanPixel(const SideVotes& side) {
  double sum = 0.0;
  for (const Vote& vote : side.votes) sum += vote.pixel;
  return sum / static_cast<double>(std::max<std::size_t>(side.votes.size(), 1));
}

}  // namespace mixed_palletizing::detection
