// What a capture is written as comes back: by PCL, OpenCV, rosbag, and our own readers, in every layout.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <mixed_palletizing/adapters/captures/capture_files.hpp>
#include <mixed_palletizing/adapters/cloud_bag.hpp>
#include <mixed_palletizing/adapters/cloud_files.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace mixed_palletizing::captures {
namespace {

class CaptureFilesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("mixed_palletizing_captures_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    simulation::Recipe recipe;
    recipe.scene.camera.width_px = 96;
    recipe.scene.camera.height_px = 60;
    recipe.scene.noise.depth_stddev_at_1m_m = 0.0003;
    recipe.scene.noise.dropout_ratio = 0.1;
    scene_ = simulation::recipeScene(recipe, 8, 0);
    capture_ = simulation::capture(scene_, 8);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const CaptureFiles& files) const { writeCaptureFiles(files, scene_, capture_, 8); }

  void expectPoint(std::size_t i, float x, float y, float z) const {
    const geometry::ColoredPoint& point = capture_.cloud.points[i];
    ASSERT_EQ(std::isnan(point.z), std::isnan(z)) << i;
    if (std::isnan(z)) return;
    ASSERT_EQ(point.x, x) << i;
    ASSERT_EQ(point.y, y) << i;
    ASSERT_EQ(point.z, z) << i;
  }

  std::filesystem::path folder_;
  simulation::Scene scene_;
  simulation::Capture capture_;
};

const std::vector<adapters::CloudLayout> kLayouts = {
    adapters::CloudLayout::kXyz, adapters::CloudLayout::kXyzrgbaFloat32,
    adapters::CloudLayout::kXyzrgbaUint32, adapters::CloudLayout::kXyzcrgb};

TEST_F(CaptureFilesTest, CloudsOfEveryLayoutComeBack) {
  for (const adapters::CloudLayout layout : kLayouts) {
    for (const std::string name : {"c.pcd", "c.ply"}) {
      SCOPED_TRACE(name + " layout " + std::to_string(static_cast<int>(layout)));
      CaptureFiles files;
      files.cloud = path(name);
      files.layout = layout;
      write(files);
      const geometry::OrganizedCloud read = adapters::readCloud(path(name));
      ASSERT_EQ(read.width, 96);
      ASSERT_EQ(read.height, 60);
      EXPECT_EQ(read.has_color, layout != adapters::CloudLayout::kXyz);
      for (std::size_t i = 0; i < read.points.size(); ++i) {
        expectPoint(i, read.points[i].x, read.points[i].y, read.points[i].z);
        const std::uint32_t rgba = read.has_color ? capture_.cloud.points[i].rgba : 0xff000000u;
        ASSERT_EQ(read.points[i].rgba, rgba) << i;
      }
    }
  }
}

TEST_F(CaptureFilesTest, PclReadsThePoints) {
  CaptureFiles files;
  files.cloud = path("c.pcd");
  write(files);
  pcl::PointCloud<pcl::PointXYZRGBA> cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(path("c.pcd"), cloud), 0);
  ASSERT_EQ(cloud.width, 96u);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    expectPoint(i, cloud[i].x, cloud[i].y, cloud[i].z);
    ASSERT_EQ(cloud[i].rgba, capture_.cloud.points[i].rgba);
  }
  files.layout = adapters::CloudLayout::kXyzcrgb;
  write(files);
  pcl::PointCloud<pcl::PointXYZRGB> colored;
  ASSERT_EQ(pcl::io::loadPCDFile(path("c.pcd"), colored), 0);
  for (std::size_t i = 0; i < colored.size(); ++i) {
    expectPoint(i, colored[i].x, colored[i].y, colored[i].z);
    ASSERT_EQ(colored[i].rgba, capture_.cloud.points[i].rgba);
  }
}

TEST_F(CaptureFilesTest, MessagesOfEveryLayoutAreReadInPlace) {
  std_msgs::Header header;
  header.frame_id = "camera";
  const std::map<adapters::CloudLayout, std::uint32_t> steps = {{adapters::CloudLayout::kXyz, 16},
                                                                {adapters::CloudLayout::kXyzrgbaFloat32, 16},
                                                                {adapters::CloudLayout::kXyzrgbaUint32, 16},
                                                                {adapters::CloudLayout::kXyzcrgb, 20}};
  for (const adapters::CloudLayout layout : kLayouts) {
    SCOPED_TRACE(static_cast<int>(layout));
    const auto message = adapters::toMessage(capture_.cloud, header, layout);
    EXPECT_EQ(message->point_step, steps.at(layout));
    const adapters::CheckedCloud checked = adapters::checkCloud(*message);
    ASSERT_TRUE(checked.view) << checked.message;
    EXPECT_EQ(checked.view->hasColor(), layout != adapters::CloudLayout::kXyz);
    for (int i = 0; i < 96 * 60; ++i) {
      const Eigen::Vector3f point = checked.view->point(i / 96, i % 96);
      expectPoint(static_cast<std::size_t>(i), point.x(), point.y(), point.z());
      if (!checked.view->hasColor()) continue;
      const std::uint8_t* bgr = checked.view->bgr(i / 96, i % 96);
      const std::uint32_t rgb = capture_.cloud.points[static_cast<std::size_t>(i)].rgba & 0xffffffu;
      ASSERT_EQ(static_cast<std::uint32_t>(bgr[0] | bgr[1] << 8 | bgr[2] << 16), rgb) << i;
    }
  }
  const auto old = adapters::toMessage(capture_.cloud, header, adapters::CloudLayout::kXyzcrgb);
  EXPECT_EQ(old->fields[3].name, "c");
  EXPECT_EQ(old->fields[3].offset, 12u);
  EXPECT_EQ(old->fields[4].name, "rgb");
  EXPECT_EQ(old->fields[4].offset, 16u);
}

TEST_F(CaptureFilesTest, ImagesShowTheCloud) {
  CaptureFiles files;
  files.color = path("color.png");
  files.depth = path("depth.tiff");
  files.mask = path("mask.png");
  write(files);
  const cv::Mat color = cv::imread(files.color, cv::IMREAD_UNCHANGED);
  const cv::Mat depth = cv::imread(files.depth, cv::IMREAD_UNCHANGED);
  const cv::Mat mask = cv::imread(files.mask, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(color.type(), CV_8UC3);
  ASSERT_EQ(depth.type(), CV_32FC1);
  ASSERT_EQ(mask.type(), CV_16UC1);
  for (const cv::Mat& image : {color, depth, mask}) ASSERT_EQ(image.size(), cv::Size(96, 60));
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 96; ++col) {
      const auto i = static_cast<std::size_t>(row * 96 + col);
      const geometry::ColoredPoint& point = capture_.cloud.points[i];
      expectPoint(i, point.x, point.y, depth.at<float>(row, col));
      const cv::Vec3b bgr = color.at<cv::Vec3b>(row, col);
      ASSERT_EQ(static_cast<std::uint32_t>(bgr[0] | bgr[1] << 8 | bgr[2] << 16), point.rgba & 0xffffffu);
      ASSERT_EQ(mask.at<std::uint16_t>(row, col), capture_.mask[i]);
    }
  }
}

TEST_F(CaptureFilesTest, CameraInfoHasTheProjection) {
  const YAML::Node info = YAML::Load(cameraInfoYaml(scene_.camera));
  const simulation::Pinhole pinhole(scene_.camera);
  EXPECT_EQ(info["image_width"].as<int>(), 96);
  EXPECT_EQ(info["image_height"].as<int>(), 60);
  EXPECT_EQ(info["camera_matrix"]["data"][0].as<double>(), pinhole.fx_px);
  EXPECT_EQ(info["camera_matrix"]["data"][2].as<double>(), pinhole.cx_px);
  EXPECT_EQ(info["camera_matrix"]["data"][5].as<double>(), pinhole.cy_px);
  EXPECT_EQ(info["projection_matrix"]["data"].size(), 12u);
}

TEST_F(CaptureFilesTest, BagsLookLikeTheDrivers) {
  for (const adapters::CloudLayout layout : {adapters::CloudLayout::kXyzrgbaFloat32,
                                             adapters::CloudLayout::kXyzcrgb, adapters::CloudLayout::kXyz}) {
    SCOPED_TRACE(static_cast<int>(layout));
    writeCaptureBag(path("c.bag"), scene_, capture_, layout, 12.5);
    const rosbag::Bag bag(path("c.bag"));
    std::map<std::string, int> topics;
    rosbag::View view(bag);
    for (const rosbag::MessageInstance& message : view) {
      ++topics[message.getTopic()];
      EXPECT_EQ(message.getTime(), ros::Time(12.5));
      if (const auto info = message.instantiate<sensor_msgs::CameraInfo>()) {
        EXPECT_EQ(info->width, 96u);
      }
      if (const auto image = message.instantiate<sensor_msgs::Image>()) {
        EXPECT_EQ(image->header.frame_id, "zivid_optical_frame");
        EXPECT_EQ(image->header.stamp, ros::Time(12.5));
      }
      if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
        ASSERT_EQ(transforms->transforms.size(), 1u);
        EXPECT_EQ(transforms->transforms[0].header.frame_id, "world");
        EXPECT_EQ(transforms->transforms[0].child_frame_id, "zivid_optical_frame");
        EXPECT_EQ(transforms->transforms[0].transform.translation.z,
                  scene_.camera.world_from_camera.translation().z());
      }
    }
    const std::string points =
        layout == adapters::CloudLayout::kXyz ? "/zivid_camera/points/xyz" : "/zivid_camera/points/xyzrgba";
    const std::map<std::string, int> expected = {{points, 1},
                                                 {"/zivid_camera/color/image_color", 1},
                                                 {"/zivid_camera/color/camera_info", 1},
                                                 {"/zivid_camera/depth/image", 1},
                                                 {"/zivid_camera/depth/camera_info", 1},
                                                 {"/tf_static", 1}};
    EXPECT_EQ(topics, expected);
    int clouds = 0;
    adapters::readCloudBag(path("c.bag"), "", [&](const sensor_msgs::PointCloud2ConstPtr& cloud) {
      EXPECT_TRUE(adapters::checkCloud(*cloud).view);
      ++clouds;
      return true;
    });
    EXPECT_EQ(clouds, 1);
  }
}

TEST_F(CaptureFilesTest, WrongEndingsAndPlacesAreErrors) {
  for (std::string CaptureFiles::*const member :
       {&CaptureFiles::color, &CaptureFiles::depth, &CaptureFiles::mask, &CaptureFiles::camera_info,
        &CaptureFiles::bag}) {
    CaptureFiles files;
    files.cloud = path("c.pcd");
    files.*member = path("x.jpg");
    EXPECT_THROW(write(files), std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(path("c.pcd")));
  }
  CaptureFiles files;
  files.mask = path("no/mask.png");
  EXPECT_THROW(write(files), std::runtime_error);
  files = CaptureFiles();
  files.bag = path("no/c.bag");
  EXPECT_THROW(write(files), std::runtime_error);
  files = CaptureFiles();
  files.truth = "/dev/full";
  EXPECT_THROW(write(files), std::runtime_error);
}

TEST(CloudLayoutNames, AreKnown) {
  for (const std::string& name : adapters::cloudLayoutNames())
    EXPECT_NO_THROW(adapters::cloudLayout(name)) << name;
  EXPECT_FALSE(adapters::optionalCloudLayout("default"));
  EXPECT_EQ(*adapters::optionalCloudLayout("xyzcrgb"), adapters::CloudLayout::kXyzcrgb);
  EXPECT_THROW(adapters::cloudLayout("xyzw"), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::captures
