#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <opencv2/imgcodecs.hpp>

#include <mixed_palletizing/experiments/cloud_picture.hpp>

namespace mixed_palletizing::experiments {
namespace {

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

void writePicture(const std::string& path, const geometry::OrganizedCloud& cloud) {
  if (!endsWith(path, ".png") && !endsWith(path, ".jpg")) {
    throw std::invalid_argument(path + ": a picture's name ends in .png or .jpg");
  }
  cv::Mat image(cloud.height, cloud.width, CV_8UC3);
  for (int row = 0; row < cloud.height; ++row) {
    std::uint8_t* out = image.ptr<std::uint8_t>(row);
    for (int col = 0; col < cloud.width; ++col, out += 3) {
      const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(cloud.width) +
                     static_cast<std::size_t>(col);
      const geometry::ColoredPoint& point = cloud.points[i];
      const unsigned divisor = std::isfinite(point.z) ? 1 : 2;
      for (unsigned channel = 0; channel < 3; ++channel) {
        out[channel] = static_cast<std::uint8_t>(((point.rgba >> (8 * channel)) & 0xffu) / divisor);
      }
    }
  }
  bool written = false;
  try {
    written = cv::imwrite(path, image);
  } catch (const cv::Exception& error) {
    throw std::runtime_error(path + ": " + error.err);
  }
  if (!written) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace mixed_palletizing::experiments
