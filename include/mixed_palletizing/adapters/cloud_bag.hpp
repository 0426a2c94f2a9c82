// Clouds in bags.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <sensor_msgs/PointCloud2.h>

namespace mixed_palletizing::adapters {

struct CloudBagOptions {
  std::string topic = "/zivid_camera/points/xyzrgba";
  std::string frame_id = "zivid_optical_frame";
  double start_s = 1.0;   ///< stamp of the first cloud, and time at which it is recorded
  double period_s = 1.0;  ///< between clouds
  int repeat = 1;         ///< the whole list is written this many times
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const CloudBagOptions& options);

/// Writes cloud files (PCD, PLY with a grid) as messages in the camera driver's layout. Throws
/// std::invalid_argument with every line of problems(options), std::runtime_error "PATH: reason" when a cloud
/// cannot be read or the bag not be written.
void writeCloudBag(const std::vector<std::string>& clouds, const std::string& bag,
                   const CloudBagOptions& options);

/// Calls `use` with every PointCloud2 of a topic in recorded order until it answers false; an empty topic means
/// the only topic of that type. Throws std::runtime_error "PATH: reason" when the bag cannot be read, has no
/// such topic, or several.
void readCloudBag(const std::string& bag, const std::string& topic,
                  const std::function<bool(const sensor_msgs::PointCloud2ConstPtr&)>& use);

}  // namespace mixed_palletizing::adapters
