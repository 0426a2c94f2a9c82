#include <cstring>
#include <stdexcept>

#include <boost/make_shared.hpp>
#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>

#include <mixed_palletizing/adapters/captures/camera_images.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>

namespace mixed_palletizing::captures {
namespace {

constexpr std::size_t kPixelBytes = 4;  // of both images

sensor_msgs::ImagePtr emptyImage(const geometry::OrganizedCloud& cloud, const std_msgs::Header& header,
                                 const char* encoding) {
  if (cloud.points.size() != cloud.view().size()) {
    throw std::invalid_argument("colorImage, depthImage: cloud: " + std::to_string(cloud.points.size()) +
                                " points: not " + std::to_string(cloud.width) + " x " +
                                std::to_string(cloud.height));
  }
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->header = header;
  image->width = static_cast<std::uint32_t>(cloud.width);
  image->height = static_cast<std::uint32_t>(cloud.height);
  image->encoding = encoding;
  image->step = static_cast<std::uint32_t>(kPixelBytes) * image->width;
  image->data.resize(kPixelBytes * cloud.points.size());
  return image;
}

}  // namespace

sensor_msgs::ImagePtr colorImage(const geometry::OrganizedCloud& cloud, const std_msgs::Header& header) {
  sensor_msgs::ImagePtr image = emptyImage(cloud, header, sensor_msgs::image_encodings::RGBA8.c_str());
  std::uint8_t* out = image->data.data();
  for (const geometry::ColoredPoint& point : cloud.points) {
    *out++ = static_cast<std::uint8_t>(point.rgba >> 16U);
    *out++ = static_cast<std::uint8_t>(point.rgba >> 8U);
    *out++ = static_cast<std::uint8_t>(point.rgba);
    *out++ = 255;
  }
  return image;
}

sensor_msgs::ImagePtr depthImage(const geometry::OrganizedCloud& cloud, const std_msgs::Header& header) {
  sensor_msgs::ImagePtr image = emptyImage(cloud, header, sensor_msgs::image_encodings::TYPE_32FC1.c_str());
  std::uint8_t* out = image->data.data();
  for (const geometry::ColoredPoint& point : cloud.points) {
    std::memcpy(out, &point.z, kPixelBytes);
    out += kPixelBytes;
  }
  return image;
}

sensor_msgs::CameraInfoPtr cameraInfo(const simulation::Camera& camera, const std_msgs::Header& header) {
  const simulation::Pinhole pinhole(camera);
  auto info = boost::make_shared<sensor_msgs::CameraInfo>();
  info->header = header;
  info->width = static_cast<std::uint32_t>(camera.width_px);
  info->height = static_cast<std::uint32_t>(camera.height_px);
  info->distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
  info->D.assign(5, 0.0);
  info->K = {pinhole.fx_px, 0.0, pinhole.cx_px, 0.0, pinhole.fy_px, pinhole.cy_px, 0.0, 0.0, 1.0};
  info->R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info->P = {pinhole.fx_px, 0.0, pinhole.cx_px, 0.0, 0.0, pinhole.fy_px,
             pinhole.cy_px, 0.0, 0.0,           0.0, 1.0, 0.0};
  return info;
}

}  // namespace mixed_palletizing::captures
