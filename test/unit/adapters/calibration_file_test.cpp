#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include <mixed_palletizing/adapters/calibration_file.hpp>

namespace mixed_palletizing::adapters {
namespace {

class CalibrationFile : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }

  void write(const std::string& text) const { std::ofstream(path_) << text; }

  void expectRefused(const std::string& text, const std::string& words) const {
    write(text);
    try {
      readCalibration(path_);
      ADD_FAILURE() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(path_ + ": ", 0), 0u) << error.what();
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }

  const std::string path_ = (std::filesystem::temp_directory_path() /
                             ("mixed_palletizing_calibration_" + std::to_string(::getpid()) + ".yaml"))
                                .string();
};

TEST_F(CalibrationFile, keepsThePlanesThatHoldNoBoxes) {
  Calibration calibration;
  calibration.removed_planes = {{Eigen::Vector3d::UnitX(), -0.7}, {Eigen::Vector3d(0.0, 0.6, 0.8), 0.1}};
  writeCalibration(path_, calibration);
  const Calibration read = readCalibration(path_);
  ASSERT_EQ(read.removed_planes.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((read.removed_planes[i].normal - calibration.removed_planes[i].normal).norm(), 1e-12);
    EXPECT_EQ(read.removed_planes[i].offset, calibration.removed_planes[i].offset);
  }
  const std::string matrix = "base_from_camera: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\n";
  expectRefused(matrix + "removed_planes: [1, 0, 0]", "removed_planes");
  expectRefused(matrix + "removed_planes: [2, 0, 0, 1]", "removed_planes");
}

TEST_F(CalibrationFile, comesBackAsItWasWritten) {
  std::mt19937 rng(91);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 50; ++i) {
    Calibration calibration;
    calibration.base_frame = "aruco_base";
    calibration.camera_frame = "camera: with a colon";
    calibration.base_from_camera.linear() =
        Eigen::Quaterniond(normal(rng), normal(rng), normal(rng), normal(rng))
            .normalized()
            .toRotationMatrix();
    calibration.base_from_camera.translation() = Eigen::Vector3d(normal(rng), normal(rng), normal(rng));
    writeCalibration(path_, calibration);
    const Calibration read = readCalibration(path_);
    EXPECT_EQ(read.base_frame, calibration.base_frame);
    EXPECT_EQ(read.camera_frame, calibration.camera_frame);
    EXPECT_LT((read.base_from_camera.matrix() - calibration.base_from_camera.matrix()).norm(), 1e-12)
        << "seed 91, case " << i;
    EXPECT_FALSE(std::filesystem::exists(path_ + ".new"));
  }
}

TEST_F(CalibrationFile, needsNoFrames) {
  write("base_from_camera: [[1, 0, 0, 0.5], [0, 1, 0, 0], [0, 0, 1, 2], [0, 0, 0, 1]]\n");
  const Calibration read = readCalibration(path_);
  EXPECT_TRUE(read.base_frame.empty());
  EXPECT_EQ(read.base_from_camera.translation(), Eigen::Vector3d(0.5, 0.0, 2.0));
}

TEST_F(CalibrationFile, refusesWhatIsNoRigidTransform) {
  EXPECT_THROW(readCalibration("/nowhere/calibration.yaml"), std::runtime_error);
  const std::string rest = ", [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\n";
  expectRefused("", "is missing");
  expectRefused("base_frame: a\n", "is missing");
  expectRefused("- 1\n", "");
  expectRefused("base_from_camera: [[1, 0, 0, 0]]\n", "four rows");
  expectRefused("base_from_camera: [[1, 0, 0]" + rest, "four rows");
  expectRefused("base_from_camera: [[1, 0, zero, 0]" + rest, "four rows");
  expectRefused("base_from_camera: [[2, 0, 0, 0]" + rest, "not a rotation");
  expectRefused("base_from_camera: [[-1, 0, 0, 0]" + rest, "not a rotation");
  expectRefused("base_from_camera: [[1, 0, 0, .nan]" + rest, "not a rotation");
  expectRefused("base_frme: a\nbase_from_camera: [[1, 0, 0, 0]" + rest, "base_frme");
  EXPECT_THROW(writeCalibration("/nowhere/calibration.yaml", Calibration()), std::runtime_error);
}

}  // namespace
}  // namespace mixed_palletizing::adapters
