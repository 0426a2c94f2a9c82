#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <opencv2/imgcodecs.hpp>

#include <mixed_palletizing/simulation/texture.hpp>

namespace mixed_palletizing::simulation {
namespace {

/// Pixels around a place along one axis, and the weight of the second.
struct Between {
  int first;
  int second;
  float weight;
};

Between around(double share, int count) {
  const double place = std::clamp(share, 0.0, 1.0) * count - 0.5;
  const int first = static_cast<int>(std::floor(place));
  return {std::clamp(first, 0, count - 1), std::clamp(first + 1, 0, count - 1),
          static_cast<float>(place - first)};
}

}  // namespace

Eigen::Vector3f Texture::at(double share_x, double share_y) const {
  const Between x = around(share_x, width_px);
  const Between y = around(share_y, height_px);
  const auto pixel = [&](int row, int col) {
    const std::uint32_t value = rgb[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px) +
                                    static_cast<std::size_t>(col)];
    return Eigen::Vector3f(static_cast<float>((value >> 16) & 0xffu),
                           static_cast<float>((value >> 8) & 0xffu), static_cast<float>(value & 0xffu));
  };
  const Eigen::Vector3f upper =
      (1.0f - x.weight) * pixel(y.first, x.first) + x.weight * pixel(y.first, x.second);
  const Eigen::Vector3f lower =
      (1.0f - x.weight) * pixel(y.second, x.first) + x.weight * pixel(y.second, x.second);
  return (1.0f - y.weight) * upper + y.weight * lower;
}

std::shared_ptr<const Texture> loadTexture(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw std::runtime_error(path + ": is no file");
  cv::Mat picture;
  try {
    picture = cv::imread(path, cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {  // said below
  }
  if (picture.empty()) throw std::runtime_error(path + ": cannot read the picture");
  auto texture = std::make_shared<Texture>();
  texture->width_px = picture.cols;
  texture->height_px = picture.rows;
  for (int row = 0; row < picture.rows; ++row) {
    for (int col = 0; col < picture.cols; ++col) {
      const cv::Vec3b& bgr = picture.at<cv::Vec3b>(row, col);
      texture->rgb.push_back(static_cast<std::uint32_t>(bgr[2]) << 16 |
                             static_cast<std::uint32_t>(bgr[1]) << 8 | static_cast<std::uint32_t>(bgr[0]));
    }
  }
  return texture;
}

}  // namespace mixed_palletizing::simulation
