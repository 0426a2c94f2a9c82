// Clouds that hold nothing to find: no crash, no box, and a message that says what was seen.
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/base_frame.hpp>
#include <mixed_palletizing/detection/box_detector.hpp>
#include <mixed_palletizing/geometry/organized_cloud.hpp>

namespace mixed_palletizing::detection {
namespace {

geometry::Pose lookingDown(double height_m) {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  pose.translation().z() = height_m;
  return pose;
}

geometry::OrganizedCloud filled(int width, int height, const geometry::ColoredPoint& point) {
  geometry::OrganizedCloud cloud;
  cloud.width = width;
  cloud.height = height;
  cloud.points.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), point);
  return cloud;
}

void expectNothing(const geometry::OrganizedCloud& cloud, const std::string& what) {
  BoxDetector detector{DetectionOptions()};
  const Detections found = detector.detect(cloud.view(), lookingDown(1.0), true);
  EXPECT_TRUE(found.boxes.empty()) << what;
  EXPECT_EQ(found.labels.size(), cloud.points.size()) << what;
  for (const BaseFrameSource source : {BaseFrameSource::kMarker, BaseFrameSource::kFloor}) {
    const BaseFrameResult result = findBaseFrame(cloud.view(), source, DetectionOptions());
    EXPECT_FALSE(result.frame) << what;
    EXPECT_FALSE(result.message.empty()) << what;
  }
}

TEST(BadInput, cloudsWithoutDataHoldNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  expectNothing(filled(64, 48, {}), "all NaN");
  expectNothing(filled(64, 48, {0.0f, 0.0f, 0.0f, 0}), "all zero");
  expectNothing(filled(64, 48, {inf, -inf, inf, 0}), "all infinite");
  expectNothing(filled(64, 48, {nan, 0.0f, 1.0f, 0}), "x is NaN");
  expectNothing(filled(64, 48, {0.0f, 0.0f, -1.0f, 0}), "behind the camera");
  expectNothing(filled(64, 48, {0.1f, 0.1f, 0.7f, 0}), "all points in one place");
  expectNothing(filled(1, 1, {0.0f, 0.0f, 1.0f, 0}), "one point");
}

TEST(BadInput, singleRowsAndColumnsHoldNothing) {
  for (const bool row : {true, false}) {
    geometry::OrganizedCloud cloud = row ? filled(1000, 1, {}) : filled(1, 1000, {});
    for (std::size_t i = 0; i < 1000; ++i) {
      const float along = 0.001f * static_cast<float>(i);
      cloud.points[i] =
          row ? geometry::ColoredPoint{along, 0.0f, 0.8f, 0} : geometry::ColoredPoint{0.0f, along, 0.8f, 0};
    }
    expectNothing(cloud, row ? "one row" : "one column");
  }
}

TEST(BadInput, anEmptyViewIsABrokenPromise) {
  BoxDetector detector{DetectionOptions()};
  EXPECT_THROW(detector.detect(geometry::CloudView(), lookingDown(1.0)), std::invalid_argument);
  EXPECT_THROW(findBaseFrame(geometry::CloudView(), BaseFrameSource::kFloor, DetectionOptions()),
               std::invalid_argument);
  const auto cloud = filled(8, 8, {});
  geometry::Pose broken = lookingDown(1.0);
  broken.linear() *= 2.0;
  EXPECT_THROW(detector.detect(cloud.view(), broken), std::invalid_argument);
  broken = lookingDown(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(detector.detect(cloud.view(), broken), std::invalid_argument);
}

TEST(BadInput, aCameraBelowOrInsideTheSceneFindsNothingButLives) {
  // The base frame is wrong: the floor lies above the camera, or everything lies far above the floor.
  auto cloud = filled(64, 48, {});
  for (int row = 0; row < 48; ++row) {
    for (int col = 0; col < 64; ++col) {
      const float z = 0.8f + 0.001f * static_cast<float>((row * 7 + col * 3) % 5);
      cloud.points[static_cast<std::size_t>(row * 64 + col)] = {
          z * 0.01f * static_cast<float>(col - 32), z * 0.01f * static_cast<float>(row - 24), z, 0};
    }
  }
  BoxDetector detector{DetectionOptions()};
  for (const double height : {-1.0, 0.0, 0.79, 0.81, 1000.0}) {
    EXPECT_TRUE(detector.detect(cloud.view(), lookingDown(height)).boxes.empty()) << height;
  }
}

}  // namespace
}  // namespace mixed_palletizing::detection
