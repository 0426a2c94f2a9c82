#include <cmath>
#include <cstring>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/captures/camera_images.hpp>
#include <mixed_palletizing/adapters/cell/simulator_options.hpp>
#include <mixed_palletizing/simulation/capture.hpp>

namespace mixed_palletizing::captures {
namespace {

simulation::Scene smallScene() {
  simulation::Scene scene = cell::cellScene({});
  scene.camera.width_px = 160;
  scene.camera.height_px = 100;
  scene.noise.dropout_ratio = 0.2;
  return scene;
}

float depthAt(const sensor_msgs::Image& image, std::size_t row, std::size_t col) {
  float depth = 0.0F;
  std::memcpy(&depth, &image.data.at(row * image.step + 4 * col), sizeof depth);
  return depth;
}

TEST(CameraImages, ShowTheCloudPixelByPixel) {
  const simulation::Scene scene = smallScene();
  const geometry::OrganizedCloud cloud = simulation::capture(scene, 1).cloud;
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(3, 4);
  const auto color = colorImage(cloud, header);
  const auto depth = depthImage(cloud, header);
  const auto info = cameraInfo(scene.camera, header);
  EXPECT_EQ(color->encoding, "rgba8");
  EXPECT_EQ(depth->encoding, "32FC1");
  for (const auto& image : {color, depth}) {
    EXPECT_EQ(image->header.frame_id, "camera");
    EXPECT_EQ(image->header.stamp, header.stamp);
    EXPECT_EQ(image->width, 160U);
    EXPECT_EQ(image->height, 100U);
    EXPECT_EQ(image->step, 640U);
    ASSERT_EQ(image->data.size(), 64000U);
  }
  EXPECT_EQ(info->width, 160U);
  EXPECT_EQ(info->height, 100U);
  EXPECT_EQ(info->D.size(), 5U);
  std::size_t missing = 0;
  for (std::size_t row = 0; row < 100; ++row) {
    for (std::size_t col = 0; col < 160; ++col) {
      const geometry::ColoredPoint& point = cloud.points[row * 160 + col];
      const std::uint8_t* rgba = &color->data[row * color->step + 4 * col];
      EXPECT_EQ(rgba[0], (point.rgba >> 16U) & 0xffU);
      EXPECT_EQ(rgba[1], (point.rgba >> 8U) & 0xffU);
      EXPECT_EQ(rgba[2], point.rgba & 0xffU);
      EXPECT_EQ(rgba[3], 255);
      if (!std::isfinite(point.z)) {
        ++missing;
        EXPECT_TRUE(std::isnan(depthAt(*depth, row, col)));
        continue;
      }
      EXPECT_EQ(depthAt(*depth, row, col), point.z);
      EXPECT_NEAR(info->K[0] * point.x / point.z + info->K[2], static_cast<double>(col), 1e-3);
      EXPECT_NEAR(info->K[4] * point.y / point.z + info->K[5], static_cast<double>(row), 1e-3);
    }
  }
  EXPECT_GT(missing, 1000U);
  EXPECT_LT(missing, 8000U);
}

TEST(CameraImages, RefuseACloudOfAnotherSize) {
  geometry::OrganizedCloud cloud;
  cloud.width = 2;
  cloud.height = 2;
  cloud.points.resize(3);
  EXPECT_THROW(colorImage(cloud, {}), std::invalid_argument);
  EXPECT_THROW(depthImage(cloud, {}), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::captures
