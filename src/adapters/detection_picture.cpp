#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <mixed_palletizing/adapters/detection_picture.hpp>

namespace mixed_palletizing::adapters {
namespace {

/// pixel = scale * tangent + offset along one axis of the image.
struct AxisFit {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;

  void add(double tangent, double pixel) {
    n += 1.0;
    x += tangent;
    y += pixel;
    xx += tangent * tangent;
    xy += tangent * pixel;
  }
  double scale() const { return (n * xy - x * y) / (n * xx - x * x); }
  double offset() const { return (y - scale() * x) / n; }
};

struct PixelModel {
  AxisFit column, row;

  cv::Point project(const Eigen::Vector3d& p) const {
    return {cvRound(column.scale() * p.x() / p.z() + column.offset()),
            cvRound(row.scale() * p.y() / p.z() + row.offset())};
  }
};

PixelModel fitPixels(const geometry::CloudView& cloud) {
  PixelModel model;
  for (int row = 0; row < cloud.height; row += 4) {
    for (int col = 0; col < cloud.width; col += 4) {
      const Eigen::Vector3d p = cloud.point(row, col).cast<double>();
      if (!p.allFinite() || p.z() <= 0.0) continue;
      model.column.add(p.x() / p.z(), col);
      model.row.add(p.y() / p.z(), row);
    }
  }
  return model;
}

cv::Mat colors(const geometry::CloudView& cloud) {
  cv::Mat image(cloud.height, cloud.width, CV_8UC3);
  for (int row = 0; row < cloud.height; ++row) {
    for (int col = 0; col < cloud.width; ++col) {
      const std::uint8_t* bgr = cloud.bgr(row, col);
      image.at<cv::Vec3b>(row, col) = {bgr[0], bgr[1], bgr[2]};
    }
  }
  return image;
}

/// Near is bright; black where there is no data.
cv::Mat depths(const geometry::CloudView& cloud) {
  cv::Mat depth(cloud.height, cloud.width, CV_32F);
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = 0.0f;
  for (int row = 0; row < cloud.height; ++row) {
    for (int col = 0; col < cloud.width; ++col) {
      const float z = cloud.point(row, col).z();
      depth.at<float>(row, col) = z;
      if (!std::isfinite(z)) continue;
      nearest = std::min(nearest, z);
      farthest = std::max(farthest, z);
    }
  }
  const float range = std::max(farthest - nearest, 1e-6f);
  cv::Mat image(cloud.height, cloud.width, CV_8UC3);
  for (int row = 0; row < cloud.height; ++row) {
    for (int col = 0; col < cloud.width; ++col) {
      const float z = depth.at<float>(row, col);
      const auto gray = std::isfinite(z)
                            ? cv::saturate_cast<std::uint8_t>(255.0f - 200.0f * (z - nearest) / range)
                            : std::uint8_t{0};
      image.at<cv::Vec3b>(row, col) = {gray, gray, gray};
    }
  }
  return image;
}

void drawBox(cv::Mat& image, const PixelModel& model, const geometry::Pose& camera_from_base,
             const GoldenBox& box, const cv::Scalar& bgr) {
  const geometry::Pose base_from_box = geometry::poseFromYaw(box.center, box.yaw_rad);
  std::array<cv::Point, 8> pixels;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Eigen::Vector3d side((i & 1u) != 0 ? 0.5 : -0.5, (i & 2u) != 0 ? 0.5 : -0.5,
                               (i & 4u) != 0 ? 0.5 : -0.5);
    const Eigen::Vector3d p = camera_from_base * (base_from_box * side.cwiseProduct(box.size));
    if (!(p.z() > 0.0)) return;
    pixels[i] = model.project(p);
  }
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (const std::size_t bit : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
      if ((i & bit) == 0) cv::line(image, pixels[i], pixels[i | bit], bgr, 2, cv::LINE_AA);
    }
  }
}

}  // namespace

void writeDetectionPicture(const std::string& path, const geometry::CloudView& cloud,
                           const geometry::Pose& base_from_camera, const std::vector<DrawnBoxes>& lists) {
  cv::Mat image = cloud.hasColor() ? colors(cloud) : depths(cloud);
  const PixelModel model = fitPixels(cloud);
  const geometry::Pose camera_from_base = base_from_camera.inverse();
  for (const DrawnBoxes& list : lists) {
    const cv::Scalar bgr(list.rgb & 0xffu, list.rgb >> 8u & 0xffu, list.rgb >> 16u & 0xffu);
    for (const GoldenBox& box : list.boxes) drawBox(image, model, camera_from_base, box, bgr);
  }
  bool written = false;
  try {
    written = cv::imwrite(path, image);
  } catch (const cv::Exception&) {
    // An unknown ending of the name; said below.
  }
  if (!written) throw std::runtime_error(path + ": the picture cannot be written");
}

}  // namespace mixed_palletizing::adapters
