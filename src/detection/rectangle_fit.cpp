#include "rectangle_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "rectangle_sides.hpp"
#include "rounded_sides.hpp"
#include "side_votes.hpp"

namespace mixed_palletizing::detection {
namespace {

using geometry::Rectangle;

constexpr int kRounds = 5;                // of choosing samples
constexpr int kReweighings = 5;           // within a round
constexpr double kTukey = 4.685;          // 95 % efficiency for normal residuals
constexpr double kNormalMedian = 0.6745;  // median of |x| for a standard normal x
constexpr double kSaw = 0.2887;           // standard deviation of a number rounded to whole pixels
constexpr double kRippleShare = 0.5;      // of the shared error of points that moves a whole side

constexpr double kSystematic = 0.25;    // [pixels] that a side may stray whatever its samples say
constexpr double kUnevenShare = 0.15;   // of the surface's unevenness, that moves its sides
constexpr double kWallStddev = 0.0006;  // [m] of a side by the wall before it: they may stand apart

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
double weigh(std::size_t side, const Solution& s, double smallest_m, std::vector<Vote>& votes,
             std::vector<double>& sizes) {
  sizes.clear();
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

/// Fits angle and offsets to the votes; returns the largest robust standard deviation of a side. It is at least
/// that of the saw: on a side whose slope is a simple fraction the teeth take few values, and the rarer of
/// them must not pass for outliers.
double fitVotes(const std::array<bool, 4>& found, FitBuffers& buffers, Solution& s) {
  std::array<SideVotes, 4>& sides = buffers.sides;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!found[i]) continue;
    buffers.values.clear();
    for (const Vote& vote : sides[i].votes) buffers.values.push_back(vote.across);
    s.offset[i] = median(buffers.values);
  }
  double scale = 0.0;
  for (int i = 0; i < kReweighings; ++i) {
    scale = 0.0;
    for (std::size_t side = 0; side < 4; ++side) {
      if (!found[side]) continue;
      const double smallest = std::max(kSaw * meanPixel(sides[side]), 1e-9);
      scale = std::max(scale, weigh(side, s, smallest, sides[side].votes, buffers.values));
    }
    solve(sides, found, s);
  }
  return scale;
}

/// Variance of a side that no number of samples takes away.
double systematic(const FitScale& scale) {
  const double pixel = kSystematic * scale.spacing_m;
  const double uneven = kUnevenShare * scale.uneven_m;
  return pixel * pixel + uneven * uneven;
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

RectangleFit fitRectangle(const std::vector<EdgeSample>& samples, const EdgeRectangle& start,
                          const FitScale& scale, FitBuffers& buffers) {
  RectangleFit fit;
  fit.rectangle = start.rectangle;
  double gate = std::max({6.0 * scale.spacing_m, 4.0 * scale.noise_m, 0.005});
  for (int round = 0; round < kRounds; ++round) {
    const Rectangle& r = fit.rectangle;
    std::array<SideVotes, 4>& sides = buffers.sides;
    std::array<bool, 4> found{};
    Solution s;
    for (std::size_t i = 0; i < 4; ++i) {
      collectVotes(samples, r, i, gate, 2.0 * scale.spacing_m, sides[i]);
      found[i] = enoughVotes(sides[i], halfAlong(r, i));
      s.offset[i] = halfAcross(r, i);
    }
    if (std::count(found.begin(), found.end(), true) == 0) break;
    const double scatter = fitVotes(found, buffers, s);
    fit.rectangle = moved(r, s);
    if ((fit.rectangle.size.array() <= 0.0).any()) return keepRectangle(start, scale);
    for (std::size_t i = 0; i < 4; ++i) {
      // Pixels cut a side into a saw: its mean is known to a pixel over the number of teeth.
      const double saw = kSaw * meanPixel(sides[i]) / std::max(1, sides[i].crossings);
      const double shared = kRippleShare * scale.ripple_m;
      const double stddev = std::sqrt(s.offset_variance[i] + saw * saw + shared * shared + systematic(scale) +
                                      sides[i].wall_share * kWallStddev * kWallStddev);
      fit.sides[i] = {found[i], sides[i].votes.size(), found[i] ? stddev : 0.0};
    }
    const double shared_turn = kRippleShare * scale.ripple_m / std::max(fit.rectangle.size.maxCoeff(), 1e-6);
    const double length = std::max(fit.rectangle.size.maxCoeff(), 1e-6);
    fit.yaw_stddev_rad =
        std::sqrt(s.turn_variance + shared_turn * shared_turn + systematic(scale) / (length * length));
    gate = std::max(2.0 * scale.spacing_m, std::min(gate, 4.0 * scatter));
  }
  fit.ends = fit.rectangle;
  moveOntoFaces(samples, scale, buffers, fit);
  return fit;
}

RectangleFit keepRectangle(const EdgeRectangle& start, const FitScale& scale) {
  RectangleFit fit;
  fit.rectangle = fit.ends = start.rectangle;
  const double stddev = scale.spacing_m + scale.noise_m;
  for (std::size_t i = 0; i < 4; ++i)
    fit.sides[i] = {start.side_found[i], 0, start.side_found[i] ? stddev : 0.0};
  fit.yaw_stddev_rad = stddev / std::max(0.5 * start.rectangle.size.maxCoeff(), 1e-6);
  return fit;
}

}  // namespace mixed_palletizing::detection
