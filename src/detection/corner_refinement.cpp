#include "corner_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include <mixed_palletizing/geometry/line2d.hpp>

namespace mixed_palletizing::detection {
namespace {

constexpr int kRounds = 3;             // each starts from the corners of the one before
constexpr double kEndShare = 0.08;     // of a side: near its ends the other sides disturb
constexpr double kReachCells = 0.35;   // how far across the side the step is looked for
constexpr double kStep = 0.25;         // [px] of the profile across
constexpr double kMinContrast = 12.0;  // grey values between the two levels of a step
constexpr std::size_t kMinPlaces = 8;
constexpr int kReweighings = 5;
constexpr double kTukey = 4.685;
constexpr double kNormalMedian = 0.6745;

/// Grey value between pixels; nothing outside of the image.
std::optional<double> grayAt(const cv::Mat& gray, const Eigen::Vector2d& at) {
  const double x = std::floor(at.x());
  const double y = std::floor(at.y());
  if (!(x >= 0.0 && y >= 0.0 && x + 1.0 < gray.cols && y + 1.0 < gray.rows)) return std::nullopt;
  const int col = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const double u = at.x() - x;
  const double v = at.y() - y;
  const auto value = [&](int r, int c) { return static_cast<double>(gray.at<std::uint8_t>(r, c)); };
  return (1 - v) * ((1 - u) * value(row, col) + u * value(row, col + 1)) +
         v * ((1 - u) * value(row + 1, col) + u * value(row + 1, col + 1));
}

/// Place of the step across `at` along `normal`, within +-reach [px]: where the area under the profile would be
/// that of a sharp step between its two end levels.
std::optional<double> stepAcross(const cv::Mat& gray, const Eigen::Vector2d& at,
                                 const Eigen::Vector2d& normal, double reach) {
  const int half = static_cast<int>(reach / kStep);
  std::vector<double> profile;
  for (int i = -half; i <= half; ++i) {
    const auto value = grayAt(gray, at + i * kStep * normal);
    if (!value) return std::nullopt;
    profile.push_back(*value);
  }
  const int level = std::max(1, half / 4);  // samples at each end that give its level
  double low = 0.0;
  double high = 0.0;
  for (int i = 0; i < level; ++i) {
    low += profile[static_cast<std::size_t>(i)] / level;
    high += profile[profile.size() - 1 - static_cast<std::size_t>(i)] / level;
  }
  if (std::abs(high - low) < kMinContrast) return std::nullopt;
  double area = 0.0;
  for (const double value : profile) area += std::clamp((high - value) / (high - low), 0.0, 1.0);
  return (area - 0.5 * static_cast<double>(profile.size())) * kStep;
}

struct Place {
  double along = 0.0;
  double across = 0.0;
  double weight = 1.0;
};

/// Line across = offset + slope * along by Tukey-weighted least squares.
void fitLine(std::vector<Place>& places, double& offset, double& slope) {
  for (int i = 0; i < kReweighings; ++i) {
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (const Place& p : places) {
      n += p.weight;
      sx += p.weight * p.along;
      sy += p.weight * p.across;
      sxx += p.weight * p.along * p.along;
      sxy += p.weight * p.along * p.across;
    }
    const double determinant = n * sxx - sx * sx;
    if (!(determinant > 1e-9 * n * n)) return;
    slope = (n * sxy - sx * sy) / determinant;
    offset = (sy - slope * sx) / n;
    std::vector<double> sizes;
    for (const Place& p : places) sizes.push_back(std::abs(p.across - offset - slope * p.along));
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    const double reach = kTukey * std::max(0.02, *middle / kNormalMedian);
    for (Place& p : places) {
      const double u = (p.across - offset - slope * p.along) / reach;
      p.weight = std::abs(u) < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
    }
  }
}

/// The step's line along the side from a to b.
std::optional<geometry::Line2d> sideLine(const cv::Mat& gray, const Eigen::Vector2d& a,
                                         const Eigen::Vector2d& b, int cells) {
  const double length = (b - a).norm();
  const double reach = std::min(8.0, kReachCells * length / cells);
  if (!(reach >= 1.0)) return std::nullopt;
  const Eigen::Vector2d along = (b - a) / length;
  const Eigen::Vector2d normal(-along.y(), along.x());
  std::vector<Place> places;
  for (double s = kEndShare * length; s <= (1.0 - kEndShare) * length; s += 1.0) {
    const auto step = stepAcross(gray, a + s * along, normal, reach);
    if (step) places.push_back({s - 0.5 * length, *step});
  }
  if (places.size() < kMinPlaces) return std::nullopt;
  double offset = 0.0;
  double slope = 0.0;
  fitLine(places, offset, slope);
  const Eigen::Vector2d middle = 0.5 * (a + b) + offset * normal;
  const Eigen::Vector2d direction = along + slope * normal;
  return geometry::Line2d::through(middle - 0.5 * length * direction, middle + 0.5 * length * direction);
}

}  // namespace

void refineCorners(const cv::Mat& gray, int cells, std::array<Eigen::Vector2d, 4>& corners) {
  for (int round = 0; round < kRounds; ++round) {
    std::array<std::optional<geometry::Line2d>, 4> lines;
    for (std::size_t i = 0; i < 4; ++i) lines[i] = sideLine(gray, corners[i], corners[(i + 1) % 4], cells);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& before = lines[(i + 3) % 4];
      if (!before || !lines[i]) continue;
      if (const auto corner = intersection(*before, *lines[i])) corners[i] = *corner;
    }
  }
}

}  // namespace mixed_palletizing::detection
