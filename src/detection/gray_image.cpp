#include "gray_image.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <opencv2/imgproc.hpp>

namespace mixed_palletizing::detection {
namespace {

constexpr double kCutShare = 0.001;  // of the pixels, at each end
constexpr double kClipLimit = 4.0;   // of CLAHE
constexpr int kTiles = 8;            // along each side of the image

/// Grey value below which `share` of the pixels lie.
int levelAt(const std::array<std::size_t, 256>& histogram, std::size_t total, double share) {
  std::size_t sum = 0;
  for (int value = 0; value < 256; ++value) {
    sum += histogram[static_cast<std::size_t>(value)];
    if (static_cast<double>(sum) > share * static_cast<double>(total)) return value;
  }
  return 255;
}

}  // namespace

cv::Mat grayImage(const geometry::CloudView& cloud) {
  if (!cloud.hasColor()) throw std::invalid_argument("grayImage: cloud: no colour");
  cv::Mat gray(cloud.height, cloud.width, CV_8U);
  std::array<std::size_t, 256> histogram{};
  for (int row = 0; row < cloud.height; ++row) {
    std::uint8_t* out = gray.ptr<std::uint8_t>(row);
    for (int col = 0; col < cloud.width; ++col) {
      const std::uint8_t* bgr = cloud.bgr(row, col);
      out[col] = static_cast<std::uint8_t>((29 * bgr[0] + 150 * bgr[1] + 77 * bgr[2]) >> 8);
      ++histogram[out[col]];
    }
  }
  const int low = levelAt(histogram, cloud.size(), kCutShare);
  const int high = levelAt(histogram, cloud.size(), 1.0 - kCutShare);
  if (high > low) gray.convertTo(gray, CV_8U, 255.0 / (high - low), -255.0 * low / (high - low));
  return gray;
}

cv::Mat evenContrast(const cv::Mat& gray) {
  cv::Mat even;
  cv::createCLAHE(kClipLimit, cv::Size(kTiles, kTiles))->apply(gray, even);
  return even;
}

}  // namespace mixed_palletizing::detection
