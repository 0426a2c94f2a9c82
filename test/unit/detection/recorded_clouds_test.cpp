// Clouds of real sensors (not part of the package), all with the default options.
#include <cmath>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/cloud_files.hpp>
#include <mixed_palletizing/detection/base_frame.hpp>
#include <mixed_palletizing/detection/box_detector.hpp>

#include "recorded_data.hpp"

namespace mixed_palletizing::detection {
namespace {

Detections detectOnFloor(const std::string& path, const DetectionOptions& options = DetectionOptions()) {
  const auto cloud = adapters::readCloud(path);
  const auto base = findBaseFrame(cloud.view(), BaseFrameSource::kFloor, options);
  EXPECT_TRUE(base.frame) << base.message;
  if (!base.frame) return {};
  BoxDetector detector(options);
  return detector.detect(cloud.view(), base.frame->base_from_camera);
}

int countOf(const Detections& found, const Eigen::Vector3d& size_m, double tolerance_m) {
  return static_cast<int>(std::count_if(found.boxes.begin(), found.boxes.end(), [&](const DetectedBox& box) {
    return ((box.size - size_m).cwiseAbs().array() <= tolerance_m).all();
  }));
}

TEST(RecordedClouds, oneCartonOnAFloor) {
  for (const char* name : {"real/fau1.pcd", "real/fau2.pcd"}) {
    const auto path = test::recordedData(name);
    if (!path) GTEST_SKIP() << name;
    const Detections found = detectOnFloor(*path);
    EXPECT_EQ(found.boxes.size(), 1u) << name;
    EXPECT_EQ(countOf(found, {0.448, 0.355, 0.187}, 0.010), 1) << name;
  }
}

TEST(RecordedClouds, aCartonAmongOtherThingsOnATable) {
  const auto path = test::recordedData("real/r200.pcd");
  if (!path) GTEST_SKIP();
  EXPECT_EQ(countOf(detectOnFloor(*path), {0.200, 0.100, 0.075}, 0.008), 1);
}

TEST(RecordedClouds, twoCartonsOneBehindTheOther) {
  const auto path = test::recordedData("real/mosd_test0.pcd");
  if (!path) GTEST_SKIP();
  const Detections found = detectOnFloor(*path);
  EXPECT_EQ(countOf(found, {0.138, 0.050, 0.212}, 0.015), 1);
  EXPECT_EQ(countOf(found, {0.260, 0.200, 0.060}, 0.020), 1);
}

TEST(RecordedClouds, whatIsNoBoxIsNone) {
  for (const char* name : {"real/oak_calibration.pcd", "real/milk.pcd"}) {
    const auto path = test::recordedData(name);
    if (!path) GTEST_SKIP() << name;
    EXPECT_TRUE(detectOnFloor(*path).boxes.empty()) << name;
  }
}

TEST(RecordedClouds, aPalletSeenFromAbove) {
  const auto path = test::recordedData("real/neura_small.pcd");
  if (!path) GTEST_SKIP();
  DetectionOptions options;
  options.mode = Mode::kDepalletize;
  const Detections found = detectOnFloor(*path, options);
  const auto tops = [&](double length_m, double width_m) {
    return std::count_if(found.boxes.begin(), found.boxes.end(), [&](const DetectedBox& box) {
      return std::abs(box.size.x() - length_m) <= 0.012 && std::abs(box.size.y() - width_m) <= 0.012;
    });
  };
  EXPECT_GE(tops(0.255, 0.155), 8);
  EXPECT_EQ(tops(0.340, 0.250), 1);
  EXPECT_LE(found.boxes.size(), 17u)
      << "13 cartons, two more cut off by the image's border, and some of the clutter";
  for (const DetectedBox& box : found.boxes) {
    EXPECT_EQ((box.flags & kHeightUnknown) != 0, box.size_stddev.z() > 0.03) << box.size.transpose();
  }
}

TEST(RecordedClouds, touchingAndStackedCartonsDoNoHarm) {
  for (const char* name : {"real/mosd_test17.pcd", "real/neura_small.pcd"}) {
    const auto path = test::recordedData(name);
    if (!path) GTEST_SKIP() << name;
    for (const DetectedBox& box : detectOnFloor(*path).boxes) {
      EXPECT_TRUE(box.size.allFinite() && box.center.allFinite() && box.pose_covariance.allFinite()) << name;
      EXPECT_TRUE((box.size_stddev.array() > 0.0).all()) << name;
    }
  }
}

}  // namespace
}  // namespace mixed_palletizing::detection
