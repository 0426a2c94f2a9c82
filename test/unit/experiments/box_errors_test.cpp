#include <cmath>

#include <gtest/gtest.h>

#include <mixed_palletizing/experiments/box_errors.hpp>

#include "hand_made_boxes.hpp"

namespace mixed_palletizing::experiments {
namespace {

using test::detected;
using test::trueBox;

const geometry::Pose kBase = geometry::Pose::Identity();

TEST(BoxErrors, AreZeroForAPerfectDetection) {
  const TrueBox truth = trueBox(0.2, -0.1, 0.4);
  const BoxErrors errors = boxErrors(truth, detected(truth), kBase, kBase);
  for (std::size_t i = 0; i < kQuantityCount; ++i) EXPECT_NEAR(errors.error[i], 0.0, 1e-12) << i;
  EXPECT_TRUE(errors.isComplete());
  EXPECT_FALSE(errors.hasSizeBeyondStddev());
}

TEST(BoxErrors, AreFoundMinusTrue) {
  const TrueBox truth = trueBox(0.2, -0.1, 0.4);
  detection::DetectedBox box = detected(truth, 0.002);
  box.top_center += Eigen::Vector3d(0.003, 0.004, -0.001);
  box.size += Eigen::Vector3d(0.001, -0.002, 0.003);
  box.yaw_rad += 0.01 - M_PI;
  const BoxErrors errors = boxErrors(truth, box, kBase, kBase);
  EXPECT_NEAR(errors.position(), 0.005, 1e-12);
  EXPECT_NEAR(errors.error[kTopZ], -0.001, 1e-12);
  EXPECT_NEAR(errors.error[kYaw], 0.01, 1e-12);
  EXPECT_NEAR(errors.error[kLength], 0.001, 1e-12);
  EXPECT_NEAR(errors.error[kWidth], -0.002, 1e-12);
  EXPECT_NEAR(errors.error[kHeight], 0.003, 1e-12);
  EXPECT_NEAR(errors.stddev[kX], 0.002, 1e-12);
  EXPECT_NEAR(errors.stddev[kHeight], 0.002, 1e-12);
  EXPECT_NEAR(errors.camera_turn_rad.norm(), 0.01, 1e-9);
}

TEST(BoxErrors, LengthAndWidthOfASquareMayBeSwapped) {
  const TrueBox truth = trueBox(0.0, 0.0, 0.1, {0.204, 0.200, 0.1});
  detection::DetectedBox box = detected(truth);
  box.yaw_rad = 0.1 - M_PI / 2 + 0.002;
  box.size = Eigen::Vector3d(0.203, 0.202, 0.1);
  const BoxErrors errors = boxErrors(truth, box, kBase, kBase);
  EXPECT_NEAR(errors.error[kYaw], 0.002, 1e-12);
  EXPECT_NEAR(errors.error[kLength], 0.003, 1e-12);
  EXPECT_NEAR(errors.error[kWidth], -0.002, 1e-12);
  const TrueBox oblong = trueBox(0.0, 0.0, 0.1);
  detection::DetectedBox across = detected(oblong);
  across.yaw_rad = 0.1 + M_PI / 2;
  EXPECT_NEAR(std::abs(boxErrors(oblong, across, kBase, kBase).error[kYaw]), M_PI / 2, 1e-12);
}

TEST(BoxErrors, AnOpenSideMayBeTheLongerOneOrTheShorter) {
  const TrueBox truth = trueBox(0.0, 0.0, 0.1, {0.30, 0.16, 0.1});
  detection::DetectedBox box = detected(truth);
  box.yaw_rad = 0.1 - M_PI / 2 + 0.002;
  box.size = Eigen::Vector3d(0.80, 0.301, 0.1);  // the true length is seen from end to end
  box.size_stddev = Eigen::Vector3d(0.4, 0.001, 0.001);
  box.flags = detection::kTruncated | detection::kIncomplete;
  const BoxErrors errors = boxErrors(truth, box, kBase, kBase);
  EXPECT_NEAR(errors.error[kYaw], 0.002, 1e-12);
  EXPECT_NEAR(errors.error[kLength], 0.64, 1e-12);
  EXPECT_NEAR(errors.error[kWidth], 0.001, 1e-12);
  EXPECT_FALSE(errors.hasSizeBeyondStddev());
}

TEST(BoxErrors, AWrongSizeIsConfidentWithoutAFlagAndBeyondItsStddev) {
  const TrueBox truth = trueBox(0.0, 0.0);
  detection::DetectedBox box = detected(truth, 0.001);
  box.size.x() += 0.0045;  // beyond three standard deviations, but small
  EXPECT_FALSE(boxErrors(truth, box, kBase, kBase).hasSizeBeyondStddev());
  box.size.x() += 0.001;
  EXPECT_TRUE(boxErrors(truth, box, kBase, kBase).hasConfidentWrongSize());
  box.flags = detection::kOccluded;
  EXPECT_TRUE(boxErrors(truth, box, kBase, kBase).hasSizeBeyondStddev());
  EXPECT_FALSE(boxErrors(truth, box, kBase, kBase).hasConfidentWrongSize());
  box.flags = 0;
  box.size_stddev.x() = 0.05;
  EXPECT_FALSE(boxErrors(truth, box, kBase, kBase).hasConfidentWrongSize());
  EXPECT_FALSE(boxErrors(truth, box, kBase, kBase).isComplete());
}

TEST(BaseFrameErrors, AreThoseOfTheFoundFrame) {
  const geometry::Pose truth = geometry::poseFromYaw({0.1, 0.2, 1.5}, 0.7);
  EXPECT_NEAR(baseFrameErrors(truth, truth).origin_m.norm(), 0.0, 1e-12);
  const geometry::Pose error = geometry::poseFromYaw({0.001, -0.002, 0.003}, 0.004);
  const BaseFrameErrors turned = baseFrameErrors(truth, error * truth);
  EXPECT_NEAR(turned.yaw_rad, 0.004, 1e-12);
  EXPECT_NEAR(turned.tilt_rad, 0.0, 1e-12);
  EXPECT_NEAR((turned.origin_m - Eigen::Vector3d(0.001, -0.002, 0.003)).norm(), 0.0, 1e-12);
  geometry::Pose tilt = geometry::Pose::Identity();
  tilt.linear() = Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX()).toRotationMatrix();
  EXPECT_NEAR(baseFrameErrors(truth, tilt * truth).tilt_rad, 0.01, 1e-9);
}

}  // namespace
}  // namespace mixed_palletizing::experiments
