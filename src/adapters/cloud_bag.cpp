#include <cmath>
#include <set>
#include <stdexcept>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <mixed_palletizing/adapters/bag_writer.hpp>
#include <mixed_palletizing/adapters/cloud_bag.hpp>
#include <mixed_palletizing/adapters/cloud_files.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>

namespace mixed_palletizing::adapters {
namespace {

constexpr double kLatestS = 4.0e9;  // ros::Time ends in 2106

std::runtime_error fault(const std::string& path, const std::string& reason) {
  return std::runtime_error(path + ": " + reason);
}

/// The topic to read: `wanted` when the bag has clouds on it, else the only one with clouds.
std::string cloudTopic(const rosbag::Bag& bag, const std::string& path, const std::string& wanted) {
  rosbag::View clouds(bag, rosbag::TypeQuery(ros::message_traits::datatype<sensor_msgs::PointCloud2>()));
  std::set<std::string> topics;
  for (const rosbag::ConnectionInfo* connection : clouds.getConnections()) topics.insert(connection->topic);
  if (topics.empty()) throw fault(path, "has no sensor_msgs/PointCloud2");
  if (wanted.empty() && topics.size() == 1) return *topics.begin();
  if (topics.count(wanted) > 0) return wanted;
  std::string list;
  for (const std::string& topic : topics) list += " " + topic;
  throw fault(
      path,
      (wanted.empty() ? "has clouds on several topics:" : "has no clouds on " + wanted + ", but on") + list);
}

}  // namespace

std::vector<std::string> problems(const CloudBagOptions& options) {
  std::vector<std::string> all;
  if (options.topic.empty()) all.push_back("topic: a name is needed");
  if (options.frame_id.empty()) all.push_back("frame_id: a name is needed");
  if (!(options.start_s > 0.0 && options.start_s < kLatestS)) {
    all.push_back("start_s: " + std::to_string(options.start_s) + " s is no time of ROS");
  }
  if (!(options.period_s > 0.0) || !std::isfinite(options.period_s)) {
    all.push_back("period_s: " + std::to_string(options.period_s) + " s is not positive");
  }
  if (options.repeat < 1) all.push_back("repeat: " + std::to_string(options.repeat) + " is not positive");
  return all;
}

void writeCloudBag(const std::vector<std::string>& clouds, const std::string& bag,
                   const CloudBagOptions& options) {
  std::string mistakes;
  for (const std::string& problem : problems(options)) mistakes += (mistakes.empty() ? "" : "; ") + problem;
  if (clouds.empty()) mistakes += std::string(mistakes.empty() ? "" : "; ") + "clouds: none";
  if (!mistakes.empty()) throw std::invalid_argument("writeCloudBag: " + mistakes);
  std::vector<geometry::OrganizedCloud> read;
  read.reserve(clouds.size());
  for (const std::string& path : clouds) read.push_back(readCloud(path));
  BagWriter file(bag);
  std_msgs::Header header;
  header.frame_id = options.frame_id;
  header.stamp.fromSec(options.start_s);
  for (int i = 0; i < options.repeat; ++i) {
    for (const geometry::OrganizedCloud& cloud : read) {
      file.write(options.topic, header.stamp, toMessage(cloud, header));
      header.stamp += ros::Duration(options.period_s);
    }
  }
  file.close();
}

void readCloudBag(const std::string& bag, const std::string& topic,
                  const std::function<bool(const sensor_msgs::PointCloud2ConstPtr&)>& use) {
  try {
    const rosbag::Bag file(bag, rosbag::bagmode::Read);
    rosbag::View view(file, rosbag::TopicQuery(cloudTopic(file, bag, topic)));
    for (const rosbag::MessageInstance& instance : view) {
      const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>();
      if (cloud && !use(cloud)) return;
    }
  } catch (const ros::Exception& error) {
    throw fault(bag, error.what());
  }
}

}  // namespace mixed_palletizing::adapters
