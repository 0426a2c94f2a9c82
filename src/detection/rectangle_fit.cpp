#include "rectangle_fit.hpp"

#include <algorithm>
#include <climits>
#include <cmath>

#include <Eigen/Dense>

namespace mixed_palletizing::detection {
namespace {

using geometry::Rectangle;

constexpr int kRounds = 5;                // of choosing samples
constexpr int kReweighings = 5;           // within a round
constexpr double kTukey = 4.685;          // 95 % efficiency for normal residuals
constexpr double kNormalMedian = 0.6745;  // median of |x| for a standard normal x
constexpr std::size_t kMinSamples = 8;    // of a side
constexpr int kBins = 20;                 // along a side, to see how much of it has samples
constexpr int kMinBins = 4;
constexpr double kCornerShare = 0.03;  // of a side: rounded corners and pixels of two sides stay out

// Outward normals in the rectangle's own axes, in the order of Rectangle::corners(), and the directions along.
const std::array<Eigen::Vector2d, 4> kOutward{Eigen::Vector2d(0, -1), Eigen::Vector2d(1, 0),
                                              Eigen::Vector2d(0, 1), Eigen::Vector2d(-1, 0)};
Eigen::Vector2d alongOf(std::size_t side) { return {-kOutward[side].y(), kOutward[side].x()}; }

double halfAcross(const Rectangle& r, std::size_t side) {
  return 0.5 * (side % 2 == 0 ? r.size.y() : r.size.x());
}
double halfAlong(const Rectangle& r, std::size_t side) {
  return 0.5 * (side % 2 == 0 ? r.size.x() : r.size.y());
}

/// True when the camera stands on the outer side of this side: its face is in view.
bool faceInView(const Rectangle& r, std::size_t side, const Eigen::Vector2d& camera) {
  return kOutward[side].dot(r.toLocal(camera)) > halfAcross(r, side);
}

/// A sample in the rectangle's axes, as seen by one side.
struct Vote {
  double across = 0.0;  // outward from the rectangle's centre
  double along = 0.0;
  double weight = 1.0;
};

struct SideVotes {
  std::vector<Vote> votes;
  int crossings = 0;  // grid lines that the side crosses against the direction its samples were found in
};

/// Samples near one side, found along the grid direction that crosses it more squarely.
SideVotes collect(const std::vector<OutlineSample>& samples, const Rectangle& r, std::size_t side,
                  bool in_view, double gate_m, double corner_m) {
  SideVotes result;
  const double reach = std::max(0.0, halfAlong(r, side) * (1.0 - kCornerShare) - corner_m);
  const double offset = halfAcross(r, side);
  const auto near = [&](const OutlineSample& sample, Vote& vote) {
    if (sample.across != Across::kFree) return false;
    const Eigen::Vector2d local = r.toLocal(in_view ? sample.at_band : sample.at_top);
    vote.across = kOutward[side].dot(local);
    vote.along = alongOf(side).dot(local);
    return std::abs(vote.along) < reach && std::abs(vote.across - offset) < gate_m;
  };
  Vote vote;
  int row_low = INT_MAX, row_high = -1, col_low = INT_MAX, col_high = -1;
  for (const OutlineSample& sample : samples) {
    if (!near(sample, vote)) continue;
    row_low = std::min(row_low, sample.row);
    row_high = std::max(row_high, sample.row);
    col_low = std::min(col_low, sample.col);
    col_high = std::max(col_high, sample.col);
  }
  if (row_high < 0) return result;
  const bool by_rows = row_high - row_low >= col_high - col_low;
  result.crossings = std::min(row_high - row_low, col_high - col_low);
  for (const OutlineSample& sample : samples) {
    if (sample.along_row == by_rows && near(sample, vote)) result.votes.push_back(vote);
  }
  return result;
}

bool enough(const SideVotes& side, double half_along) {
  if (side.votes.size() < kMinSamples) return false;
  std::array<bool, kBins> filled{};
  for (const Vote& vote : side.votes) {
    const int bin = static_cast<int>((vote.along / half_along + 1.0) * 0.5 * kBins);
    filled[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))] = true;
  }
  return std::count(filled.begin(), filled.end(), true) >= kMinBins;
}

/// Angle and four offsets, with their variances.
struct Solution {
  double turn_rad = 0.0;
  double turn_variance = 0.0;
  std::array<double, 4> offset{};
  std::array<double, 4> offset_variance{};
};

double residual(const Vote& vote, std::size_t side, const Solution& s) {
  return vote.across - s.turn_rad * vote.along - s.offset[side];
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Tukey's weights over the variance of the side's residuals; returns their robust standard deviation.
double weigh(std::size_t side, const Solution& s, double smallest_m, std::vector<Vote>& votes) {
  std::vector<double> sizes;
  for (const Vote& vote : votes) sizes.push_back(std::abs(residual(vote, side, s)));
  const double scale = std::max(smallest_m, median(sizes) / kNormalMedian);
  for (Vote& vote : votes) {
    const double u = residual(vote, side, s) / (kTukey * scale);
    vote.weight = std::abs(u) < 1.0 ? (1.0 - u * u) * (1.0 - u * u) / (scale * scale) : 0.0;
  }
  return scale;
}

/// Weighted least squares for across = offset + turn * along on every found side; the others stay.
void solve(const std::array<SideVotes, 4>& sides, const std::array<bool, 4>& found, Solution& s) {
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    const auto k = static_cast<Eigen::Index>(i + 1);
    if (!found[i]) {
      normal(k, k) = 1.0;
      right(k) = s.offset[i];
      continue;
    }
    for (const Vote& vote : sides[i].votes) {
      normal(0, 0) += vote.weight * vote.along * vote.along;
      normal(0, k) += vote.weight * vote.along;
      normal(k, k) += vote.weight;
      right(0) += vote.weight * vote.along * vote.across;
      right(k) += vote.weight * vote.across;
    }
    normal(k, 0) = normal(0, k);
  }
  const Eigen::Matrix<double, 5, 5> inverse = normal.inverse();
  const Eigen::Matrix<double, 5, 1> x = inverse * right;
  s.turn_rad = x(0);
  s.turn_variance = inverse(0, 0);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto k = static_cast<Eigen::Index>(i + 1);
    s.offset[i] = x(k);
    s.offset_variance[i] = inverse(k, k);
  }
}

/// Fits angle and offsets to the votes; returns the largest robust standard deviation of a side.
double fitVotes(std::array<SideVotes, 4>& sides, const std::array<bool, 4>& found, double smallest_m,
                Solution& s) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!found[i]) continue;
    std::vector<double> across;
    for (const Vote& vote : sides[i].votes) across.push_back(vote.across);
    s.offset[i] = median(across);
  }
  double scale = smallest_m;
  for (int i = 0; i < kReweighings; ++i) {
    scale = smallest_m;
    for (std::size_t side = 0; side < 4; ++side) {
      if (found[side]) scale = std::max(scale, weigh(side, s, smallest_m, sides[side].votes));
    }
    solve(sides, found, s);
  }
  return scale;
}

/// The rectangle with its sides at the offsets, turned.
Rectangle moved(const Rectangle& r, const Solution& s) {
  Rectangle result;
  // A side turned to the left falls back where it runs ahead.
  result.yaw_rad = r.yaw_rad - s.turn_rad;
  // The offsets are measured from the old centre along the new axes.
  result.center = r.center + 0.5 * (s.offset[1] - s.offset[3]) * result.axisX() +
                  0.5 * (s.offset[2] - s.offset[0]) * result.axisY();
  result.size = Eigen::Vector2d(s.offset[1] + s.offset[3], s.offset[0] + s.offset[2]);
  return result;
}

}  // namespace

int RectangleFit::foundSides() const {
  return static_cast<int>(
      std::count_if(sides.begin(), sides.end(), [](const SideFit& s) { return s.found; }));
}

RectangleFit fitRectangle(const std::vector<OutlineSample>& samples, const EdgeRectangle& start,
                          const Eigen::Vector2d& camera, const FitScale& scale) {
  RectangleFit fit;
  fit.rectangle = start.rectangle;
  double gate = std::max({6.0 * scale.spacing_m, 4.0 * scale.noise_m, 0.005});
  const double smallest_scale = std::max(0.1 * scale.spacing_m, 1e-6);
  for (int round = 0; round < kRounds; ++round) {
    const Rectangle& r = fit.rectangle;
    std::array<SideVotes, 4> sides;
    std::array<bool, 4> found{};
    Solution s;
    for (std::size_t i = 0; i < 4; ++i) {
      sides[i] = collect(samples, r, i, faceInView(r, i, camera), gate, 2.0 * scale.spacing_m);
      found[i] = enough(sides[i], halfAlong(r, i));
      s.offset[i] = halfAcross(r, i);
    }
    if (std::count(found.begin(), found.end(), true) == 0) break;
    const double scatter = fitVotes(sides, found, smallest_scale, s);
    fit.rectangle = moved(r, s);
    if ((fit.rectangle.size.array() <= 0.0).any()) return keepRectangle(start, scale);
    for (std::size_t i = 0; i < 4; ++i) {
      // Pixels cut a side into a saw: its mean is known to a pixel over the number of teeth.
      const double saw = scale.spacing_m / std::sqrt(12.0) / std::max(1, sides[i].crossings);
      fit.sides[i] = {found[i], sides[i].votes.size(), std::sqrt(s.offset_variance[i] + saw * saw)};
    }
    fit.yaw_stddev_rad = std::sqrt(s.turn_variance);
    gate = std::max(2.0 * scale.spacing_m, std::min(gate, 4.0 * scatter));
  }
  return fit;
}

RectangleFit keepRectangle(const EdgeRectangle& start, const FitScale& scale) {
  RectangleFit fit;
  fit.rectangle = start.rectangle;
  const double stddev = scale.spacing_m + scale.noise_m;
  for (std::size_t i = 0; i < 4; ++i) fit.sides[i] = {start.side_found[i], 0, stddev};
  fit.yaw_stddev_rad = stddev / std::max(0.5 * start.rectangle.size.maxCoeff(), 1e-6);
  return fit;
}

OutlineMatch matchOutline(const std::vector<OutlineSample>& samples, const Rectangle& rectangle,
                          const Eigen::Vector2d& camera, double tolerance_m) {
  OutlineMatch match;
  std::array<bool, 4> in_view{};
  for (std::size_t i = 0; i < 4; ++i) in_view[i] = faceInView(rectangle, i, camera);
  double free = 0.0;
  for (const OutlineSample& sample : samples) {
    if (sample.across == Across::kOccluder) match.occluded_ratio += 1.0;
    if (sample.across == Across::kBorder) match.border_ratio += 1.0;
    if (sample.across != Across::kFree) continue;
    free += 1.0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector2d local = rectangle.toLocal(in_view[i] ? sample.at_band : sample.at_top);
      if (std::abs(alongOf(i).dot(local)) > halfAlong(rectangle, i) + tolerance_m) continue;
      if (std::abs(kOutward[i].dot(local) - halfAcross(rectangle, i)) > tolerance_m) continue;
      match.on_sides_ratio += 1.0;
      break;
    }
  }
  const double all = std::max(1.0, static_cast<double>(samples.size()));
  match.occluded_ratio /= all;
  match.border_ratio /= all;
  match.on_sides_ratio /= std::max(1.0, free);
  return match;
}

}  // namespace mixed_palletizing::detection
