// Cloud files: what is written comes back, every foreign layout is read, every damaged file is a clear error.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include <mixed_palletizing/adapters/cloud_files.hpp>

namespace mixed_palletizing::adapters {
namespace {

using geometry::ColoredPoint;
using geometry::OrganizedCloud;

class CloudFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("mixed_palletizing_cloud_files_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  /// Message of the error that reading a file with this content gives; empty when it is read.
  std::string errorOf(const std::string& name, const std::string& text) const {
    write(name, text);
    try {
      readCloud(path(name));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }

  std::filesystem::path folder_;
};

OrganizedCloud randomCloud(std::uint32_t seed, bool has_color) {
  std::mt19937 random(seed);
  OrganizedCloud cloud;
  cloud.width = 2 + static_cast<int>(random() % 30);
  cloud.height = 2 + static_cast<int>(random() % 20);
  cloud.has_color = has_color;
  for (int i = 0; i < cloud.width * cloud.height; ++i) {
    ColoredPoint point;
    if (random() % 4 != 0) {
      point.x = static_cast<float>(random() % 1000) * 0.001f;
      point.y = static_cast<float>(random() % 1000) * -0.001f;
      point.z = 1.0f + static_cast<float>(random() % 1000) * 0.001f;
    }
    if (has_color) point.rgba = 0xff000000u | static_cast<std::uint32_t>(random() & 0xffffffu);
    cloud.points.push_back(point);
  }
  return cloud;
}

void expectSame(const OrganizedCloud& a, const OrganizedCloud& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  ASSERT_EQ(a.has_color, b.has_color);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    ASSERT_EQ(std::isnan(a.points[i].z), std::isnan(b.points[i].z)) << i;
    if (!std::isnan(a.points[i].z)) {
      ASSERT_EQ(a.points[i].x, b.points[i].x) << i;
      ASSERT_EQ(a.points[i].y, b.points[i].y) << i;
      ASSERT_EQ(a.points[i].z, b.points[i].z) << i;
    }
    ASSERT_EQ(a.points[i].rgba, b.points[i].rgba) << i;
  }
}

TEST_F(CloudFiles, WhatIsWrittenComesBack) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    for (const bool has_color : {true, false}) {
      for (const std::string name : {"c.pcd", "c.ply"}) {
        SCOPED_TRACE(name + " seed " + std::to_string(seed));
        const OrganizedCloud cloud = randomCloud(seed, has_color);
        writeCloud(path(name), cloud);
        expectSame(cloud, readCloud(path(name)));
      }
    }
  }
}

const char* const kAsciiPcd =
    "VERSION 0.7\nFIELDS intensity z y x rgb\nSIZE 4 8 8 8 4\nTYPE F F F F F\nCOUNT 1 1 1 1 1\nWIDTH 2\n"
    "HEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n";

TEST_F(CloudFiles, ReadsForeignFieldOrderAndDoubles) {
  write("a.pcd", std::string(kAsciiPcd) + "9 1.5 2 3 0\n9 nan nan nan 0\n9 1.25 -2 3 0\n9 1 2 3 0\n");
  const OrganizedCloud cloud = readCloud(path("a.pcd"));
  ASSERT_EQ(cloud.width, 2);
  ASSERT_EQ(cloud.height, 2);
  EXPECT_TRUE(cloud.has_color);
  EXPECT_EQ(cloud.points[0].x, 3.0f);
  EXPECT_EQ(cloud.points[0].y, 2.0f);
  EXPECT_EQ(cloud.points[0].z, 1.5f);
  EXPECT_TRUE(std::isnan(cloud.points[1].x));
  EXPECT_EQ(cloud.points[2].y, -2.0f);
}

TEST_F(CloudFiles, ReadsAsciiPlyWithGrid) {
  write(
      "a.ply",
      "ply\nformat ascii 1.0\nobj_info num_cols 2\nobj_info num_rows 2\nelement vertex 4\nproperty float x\n"
      "property float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "end_header\n0 0 1 1 2 3\n1 0 1 4 5 6\nnan nan nan 0 0 0\n1 1 2 7 8 9\n");
  const OrganizedCloud cloud = readCloud(path("a.ply"));
  ASSERT_EQ(cloud.width, 2);
  ASSERT_EQ(cloud.height, 2);
  EXPECT_EQ(cloud.points[1].rgba & 0xffffffu, 0x040506u);
  EXPECT_TRUE(std::isnan(cloud.points[2].z));
  EXPECT_EQ(cloud.points[3].z, 2.0f);
}

TEST_F(CloudFiles, EveryTruncationIsAnError) {
  for (const std::string name : {"c.pcd", "c.ply"}) {
    writeCloud(path(name), randomCloud(7, true));
    const std::string whole = read(name);
    for (std::size_t length = 0; length < whole.size(); length += 1 + length / 9) {
      const std::string error = errorOf("t" + name.substr(1), whole.substr(0, length));
      EXPECT_NE(error.find(path("t" + name.substr(1)) + ": "), std::string::npos)
          << name << " cut at " << length;
      EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
  }
}

TEST_F(CloudFiles, DamagedHeadersNeverCrash) {
  for (const std::string name : {"c.pcd", "c.ply"}) {
    writeCloud(path(name), randomCloud(3, true));
    const std::string whole = read(name);
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
      std::mt19937 random(seed);
      std::string text = whole;
      const std::size_t at = random() % 250;
      if (seed % 3 == 0) text[at] = static_cast<char>(random());
      if (seed % 3 == 1) text.erase(at, 1 + random() % 20);
      if (seed % 3 == 2) text.insert(at, std::to_string(random()));
      SCOPED_TRACE(name + " seed " + std::to_string(seed));
      EXPECT_EQ(errorOf("d" + name.substr(1), text).find('\n'), std::string::npos);
    }
  }
}

TEST_F(CloudFiles, ErrorsSayWhatIsWrong) {
  const std::string rows = "9 1 2 3 0\n9 1 2 3 0\n9 1 2 3 0\n9 1 2 3 0\n";
  const auto pcd = [&](const std::string& from, const std::string& to) {
    std::string text = kAsciiPcd + rows;
    text.replace(text.find(from), from.size(), to);
    return errorOf("e.pcd", text);
  };
  EXPECT_NE(pcd(" x ", " q ").find("no field 'x'"), std::string::npos);
  EXPECT_NE(pcd("WIDTH 2\nHEIGHT 2", "WIDTH 4\nHEIGHT 1").find("not organized: 4 x 1"), std::string::npos);
  EXPECT_NE(pcd("TYPE F F", "TYPE F U").find("field 'z' is not a float"), std::string::npos);
  EXPECT_NE(pcd("POINTS 4", "POINTS 400000000000").find("promises"), std::string::npos);
  EXPECT_NE(errorOf("e.pcd", "").find("not a PCD file"), std::string::npos);
  EXPECT_NE(errorOf("e.ply", "hello").find("not a PLY file"), std::string::npos);
  EXPECT_NE(errorOf("e.txt", "hello").find("neither .pcd nor .ply"), std::string::npos);
  EXPECT_THROW(readCloud(path("missing.pcd")), std::runtime_error);
}

TEST_F(CloudFiles, WritingRefusesWhatCannotBe) {
  OrganizedCloud cloud = randomCloud(1, true);
  EXPECT_THROW(writeCloud(path("no/such/folder.pcd"), cloud), std::runtime_error);
  EXPECT_THROW(writeCloud(path("c.txt"), cloud), std::runtime_error);
  cloud.points.pop_back();
  EXPECT_THROW(writeCloud(path("c.pcd"), cloud), std::invalid_argument);
}

TEST_F(CloudFiles, ReadsRecordedClouds) {
  const char* given = std::getenv("MIXED_PALLETIZING_DATA");
  const std::filesystem::path data =
      given != nullptr ? given : MIXED_PALLETIZING_SOURCE_DIR "/../shared/data";
  const std::filesystem::path file = data / "real" / "fau1.pcd";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no recorded clouds in " << data;
  const OrganizedCloud cloud = readCloud(file.string());
  EXPECT_EQ(cloud.width, 512);
  EXPECT_EQ(cloud.height, 424);
  EXPECT_TRUE(cloud.has_color);
}

}  // namespace
}  // namespace mixed_palletizing::adapters
