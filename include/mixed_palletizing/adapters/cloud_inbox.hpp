// The latest cloud, and threads that wait for the next one.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>

#include <sensor_msgs/PointCloud2.h>

#include <mixed_palletizing/geometry/cloud_view.hpp>

namespace mixed_palletizing::adapters {

/// A cloud that passed all checks. The view points into the message.
struct AcceptedCloud {
  sensor_msgs::PointCloud2ConstPtr message;
  geometry::CloudView view;
  std::uint64_t sequence = 0;  ///< of arrival, from 1, dropped clouds counted too
};

/// What came: a cloud, or why one was dropped.
struct Arrival {
  enum class Kind { kCloud, kDropped, kTimeout, kClosed };
  Kind kind = Kind::kTimeout;
  AcceptedCloud cloud;
  std::string dropped;  ///< the reason, with kTimeout too where one is known
  ros::Time stamp;      ///< of the cloud, dropped or not
  ros::Time received;   ///< ROS time when it came
  std::uint64_t sequence = 0;
};

/// True when the cloud is stamped more than a second later than it came: the clocks disagree.
bool aheadOfTheClock(const Arrival& arrival);

/// Thread safe. Holds the last cloud when it was accepted: some 37 MB of a 1920x1200 camera, shared with the driver.
class CloudInbox {
 public:
  using Deadline = std::chrono::steady_clock::time_point;

  /// Both answer the number of the arrival. `now`: ROS time.
  std::uint64_t accept(AcceptedCloud cloud, const ros::Time& now);
  std::uint64_t drop(const std::string& reason, const ros::Time& stamp, const ros::Time& now);

  /// Number of the last arrival, 0 before the first.
  std::uint64_t sequence() const;

  /// The last arrival when its stamp is not before `not_before` (zero: never); kTimeout otherwise. An arrival
  /// from before the clock was put back is no answer, nor one from ahead of it: such stamps cannot be compared.
  Arrival since(const ros::Time& not_before, const ros::Time& now) const;

  /// The last arrival; kTimeout before the first.
  Arrival latest() const;

  /// The last arrival after number `sequence`, waiting for it until the deadline.
  Arrival waitAfter(std::uint64_t sequence, Deadline deadline);

  /// Wakes all who wait; from now on nobody waits.
  void close();

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool closed_ = false;
  Arrival last_;
};

}  // namespace mixed_palletizing::adapters
