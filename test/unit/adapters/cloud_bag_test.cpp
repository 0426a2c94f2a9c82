#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/Header.h>

#include <mixed_palletizing/adapters/cloud_bag.hpp>
#include <mixed_palletizing/adapters/cloud_files.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>

namespace mixed_palletizing::adapters {
namespace {

std::string temporary(const std::string& name) { return testing::TempDir() + "cloud_bag_" + name; }

/// A file with a sloping floor, `depth` m away at its corner.
std::string cloudFile(const std::string& name, float depth) {
  geometry::OrganizedCloud cloud;
  cloud.width = 20;
  cloud.height = 10;
  for (int i = 0; i < 200; ++i) {
    geometry::ColoredPoint point;
    point.x = 0.01f * static_cast<float>(i % 20);
    point.y = 0.01f * static_cast<float>(i / 20);
    point.z = depth;
    cloud.points.push_back(point);
  }
  const std::string path = temporary(name);
  writeCloud(path, cloud);
  return path;
}

std::vector<sensor_msgs::PointCloud2ConstPtr> readAll(const std::string& bag, const std::string& topic) {
  std::vector<sensor_msgs::PointCloud2ConstPtr> clouds;
  readCloudBag(bag, topic, [&](const sensor_msgs::PointCloud2ConstPtr& cloud) {
    clouds.push_back(cloud);
    return true;
  });
  return clouds;
}

TEST(CloudBag, holdsTheCloudsInTheDriversLayout) {
  const std::string bag = temporary("good.bag");
  CloudBagOptions options;
  options.repeat = 2;
  options.period_s = 0.5;
  writeCloudBag({cloudFile("a.pcd", 1.0f), cloudFile("b.ply", 2.0f)}, bag, options);
  const auto clouds = readAll(bag, "");
  ASSERT_EQ(clouds.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(clouds[i]->header.frame_id, "zivid_optical_frame");
    EXPECT_EQ(clouds[i]->header.stamp, ros::Time(1.0 + 0.5 * static_cast<double>(i)));
    EXPECT_EQ(clouds[i]->point_step, 16u);
    const CheckedCloud checked = checkCloud(*clouds[i]);
    ASSERT_TRUE(checked.view) << checked.message;
    EXPECT_EQ(checked.view->point(0, 0).z(), i % 2 == 0 ? 1.0f : 2.0f);
  }
  EXPECT_EQ(readAll(bag, "/zivid_camera/points/xyzrgba").size(), 4u);
  int calls = 0;
  readCloudBag(bag, "", [&](const auto&) { return ++calls < 2; });
  EXPECT_EQ(calls, 2);
}

TEST(CloudBag, refusesWrongOptionsAndFiles) {
  const std::string cloud = cloudFile("c.pcd", 1.0f);
  const std::string bag = temporary("refused.bag");
  CloudBagOptions options;
  EXPECT_THROW(writeCloudBag({}, bag, options), std::invalid_argument);
  EXPECT_THROW(writeCloudBag({"/nowhere.pcd"}, bag, options), std::runtime_error);
  EXPECT_THROW(writeCloudBag({cloud}, "/nowhere/x.bag", options), std::runtime_error);
  for (auto change :
       {+[](CloudBagOptions& o) { o.topic.clear(); }, +[](CloudBagOptions& o) { o.frame_id.clear(); },
        +[](CloudBagOptions& o) { o.start_s = 0.0; }, +[](CloudBagOptions& o) { o.start_s = 1e12; },
        +[](CloudBagOptions& o) { o.period_s = -1.0; }, +[](CloudBagOptions& o) { o.repeat = 0; }}) {
    CloudBagOptions wrong;
    change(wrong);
    EXPECT_EQ(problems(wrong).size(), 1u);
    EXPECT_THROW(writeCloudBag({cloud}, bag, wrong), std::invalid_argument);
  }
}

TEST(CloudBag, refusesBagsWithoutTheTopic) {
  EXPECT_THROW(readAll("/nowhere.bag", ""), std::runtime_error);
  const std::string broken = temporary("broken.bag");
  std::ofstream(broken) << "this is no bag";
  EXPECT_THROW(readAll(broken, ""), std::runtime_error);
  const std::string other = temporary("other.bag");
  {
    rosbag::Bag bag(other, rosbag::bagmode::Write);
    bag.write("header", ros::Time(1, 0), std_msgs::Header());
  }
  EXPECT_THROW(readAll(other, ""), std::runtime_error);
  {
    rosbag::Bag bag(other, rosbag::bagmode::Write);
    bag.write("a", ros::Time(1, 0), sensor_msgs::PointCloud2());
    bag.write("b", ros::Time(1, 0), sensor_msgs::PointCloud2());
  }
  EXPECT_THROW(readAll(other, ""), std::runtime_error);
  EXPECT_THROW(readAll(other, "c"), std::runtime_error);
  EXPECT_EQ(readAll(other, "b").size(), 1u);
}

}  // namespace
}  // namespace mixed_palletizing::adapters
