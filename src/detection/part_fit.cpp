#include "part_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "side_walk.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kEndShare = 0.08;  // of a side's length, at both ends: the other sides disturb there
constexpr int kRounds = 8;
constexpr double kTukey = 4.685;
constexpr double kNormalMedian = 0.6745;
constexpr double kPictureShare =
    0.75;                        // of a cell, that a side of the picture may stray whatever its places say
constexpr double kSaw = 0.2887;  // standard deviation of a number rounded to whole cells

struct Place {
  double along;
  double across;
  double weight;
};

struct Solution {
  double turn = 0.0;  // of all sides, to the left
  std::array<double, 4> offset{};
};

/// across = offset + slope * along, the slope being -turn for upright sides and +turn for the others.
double slopeOf(std::size_t side, double turn) { return isUpright(side) ? -turn : turn; }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void solve(const std::array<std::vector<Place>, 4>& sides, Solution& s) {
  Eigen::Matrix<double, 5, 5> normal = 1e-9 * Eigen::Matrix<double, 5, 5>::Identity();
  Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    for (const Place& p : sides[i]) {
      Eigen::Matrix<double, 5, 1> gain = Eigen::Matrix<double, 5, 1>::Zero();
      gain(0) = isUpright(i) ? -p.along : p.along;
      gain(static_cast<Eigen::Index>(i + 1)) = 1.0;
      normal += p.weight * gain * gain.transpose();
      right += p.weight * p.across * gain;
    }
  }
  const Eigen::Matrix<double, 5, 1> x = normal.ldlt().solve(right);
  s.turn = x(0);
  for (std::size_t i = 0; i < 4; ++i) {
    if (!sides[i].empty()) s.offset[i] = x(static_cast<Eigen::Index>(i + 1));
  }
}

/// Tukey's weights; returns the robust spread of a side in cells.
double weigh(std::size_t side, const Solution& s, std::vector<Place>& places) {
  std::vector<double> sizes;
  for (const Place& p : places)
    sizes.push_back(std::abs(p.across - s.offset[side] - slopeOf(side, s.turn) * p.along));
  const double scale = std::max(kSaw, median(sizes) / kNormalMedian);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double u = sizes[i] / (kTukey * scale);
    places[i].weight = u < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
  }
  return scale;
}

geometry::Rectangle toRectangle(const TopPicture& picture, const Eigen::Vector2d& middle, const Solution& s) {
  // Offsets are measured from `middle`; to first order of the small turn the sides stay where they are there.
  const double u = 0.5 * (s.offset[1] + s.offset[3]);
  const double v = 0.5 * (s.offset[0] + s.offset[2]);
  geometry::Rectangle rectangle;
  rectangle.center = picture.place(middle + Eigen::Vector2d(u - s.turn * v, v + s.turn * u));
  rectangle.yaw_rad = picture.yaw() + s.turn;
  rectangle.size = picture.cell() * Eigen::Vector2d(s.offset[1] - s.offset[3], s.offset[2] - s.offset[0]);
  return rectangle;
}

/// Share of the rectangle that is top, from the picture.
double filledShare(const TopPicture& picture, const geometry::Rectangle& rectangle) {
  std::size_t top = 0;
  std::size_t all = 0;
  for (int v = 0; v < picture.rows(); ++v) {
    for (int u = 0; u < picture.cols(); ++u) {
      if (!rectangle.contains(picture.place(Eigen::Vector2d(u, v)))) continue;
      ++all;
      top += picture.isTop(u, v) ? 1 : 0;
    }
  }
  return all > 0 ? static_cast<double>(top) / static_cast<double>(all) : 0.0;
}

}  // namespace

PartFit fitPart(const TopPicture& picture, const TopPart& part) {
  PartFit fit;
  const Eigen::Vector2d middle(
      0.5 * (part[1].offset + part[3].offset) +
          0.5 * (part[1].slope + part[3].slope) * 0.5 * (part[0].offset + part[2].offset),
      0.5 * (part[0].offset + part[2].offset) +
          0.5 * (part[0].slope + part[2].slope) * 0.5 * (part[1].offset + part[3].offset));
  std::array<std::vector<Place>, 4> sides;
  Solution s;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t before = (i + 3) % 4;
    const std::size_t after = (i + 1) % 4;
    const double at = isUpright(i) ? middle.x() : middle.y();
    const double begin =
        std::min(part[before].offset + part[before].slope * at, part[after].offset + part[after].slope * at);
    const double end =
        std::max(part[before].offset + part[before].slope * at, part[after].offset + part[after].slope * at);
    const double origin = isUpright(i) ? middle.y() : middle.x();
    const double margin = kEndShare * (end - begin);
    const SideWalk walk(picture, part, i, begin + margin, end - margin);
    int below = 0, above = 0, count = 0;
    for (double along = begin + margin; along <= end - margin; along += 1.0) {
      ++count;
      TopCell behind = TopCell::kNoData;
      const auto across = walk.endAt(along, behind);
      below += behind == TopCell::kBelow ? 1 : 0;
      above += behind == TopCell::kAbove ? 1 : 0;
      if (across) sides[i].push_back({along - origin, *across - at, 1.0});
    }
    s.offset[i] = walk.nominal(origin) - at;
    if (count == 0) continue;
    fit.sides[i].below = static_cast<double>(below) / count;
    fit.sides[i].above = static_cast<double>(above) / count;
  }
  std::array<double, 4> spread{};
  for (int round = 0; round < kRounds; ++round) {
    solve(sides, s);
    for (std::size_t i = 0; i < 4; ++i) {
      if (!sides[i].empty()) spread[i] = weigh(i, s, sides[i]);
    }
  }
  fit.rectangle = toRectangle(picture, middle, s);
  double arm = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    // Neighbouring places share their errors: as many of them are independent as fit into the reach.
    const double independent =
        std::max(1.0, static_cast<double>(sides[i].size()) * picture.cell() / kReachOut_m);
    const double known = sides[i].empty() ? kReachOut_m : picture.cell() * spread[i] / std::sqrt(independent);
    fit.sides[i].stddev_m = std::hypot(known, kPictureShare * picture.cell());
    arm = std::max(arm, static_cast<double>(sides[i].size()) * picture.cell());
  }
  fit.yaw_stddev_rad = 2.0 * picture.cell() / std::max(arm, 1e-3);
  fit.filled = filledShare(picture, fit.rectangle);
  return fit;
}

}  // namespace mixed_palletizing::detection
