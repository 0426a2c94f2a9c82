#include "gray_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/core.hpp>

namespace mixed_palletizing::detection {
namespace {

constexpr double kStep = 0.25;         // [px] of the profile
constexpr int kLargestHalf = 40;       // samples on one side
constexpr double kMinContrast = 12.0;  // grey values between the two levels

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

}  // namespace

std::optional<GrayStep> findGrayStep(const cv::Mat& gray, const Eigen::Vector2d& at,
                                     const Eigen::Vector2d& direction, double reach) {
  const int half = std::min(kLargestHalf, static_cast<int>(reach / kStep));
  std::array<double, 2 * kLargestHalf + 1> profile{};
  const int count = 2 * half + 1;
  for (int i = 0; i < count; ++i) {
    const auto value = grayAt(gray, at + (i - half) * kStep * direction);
    if (!value) return std::nullopt;
    profile[static_cast<std::size_t>(i)] = *value;
  }
  const int level = std::max(1, half / 4);  // samples at each end that give its level
  double low = 0.0;
  double high = 0.0;
  for (int i = 0; i < level; ++i) {
    low += profile[static_cast<std::size_t>(i)] / level;
    high += profile[static_cast<std::size_t>(count - 1 - i)] / level;
  }
  if (std::abs(high - low) < kMinContrast) return std::nullopt;
  double area = 0.0;
  for (int i = 0; i < count; ++i) {
    area += std::clamp((high - profile[static_cast<std::size_t>(i)]) / (high - low), 0.0, 1.0);
  }
  return GrayStep{(area - 0.5 * count) * kStep, high - low};
}

}  // namespace mixed_palletizing::detection
