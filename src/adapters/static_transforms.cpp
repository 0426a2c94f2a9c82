#include <memory>
#include <mutex>

#include <geometry_msgs/TransformStamped.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/static_transforms.hpp>

namespace mixed_palletizing::adapters {

void publishStaticTransform(const std::string& parent, const std::string& child,
                            const geometry::Pose& parent_from_child, const ros::Time& stamp) {
  static std::mutex mutex;
  static std::unique_ptr<tf2_ros::StaticTransformBroadcaster> broadcaster;
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent;
  message.header.stamp = stamp;
  message.child_frame_id = child;
  message.transform.translation = vectorMessage(parent_from_child.translation());
  message.transform.rotation = quaternionMessage(parent_from_child.linear());
  std::lock_guard<std::mutex> lock(mutex);
  if (!broadcaster) broadcaster = std::make_unique<tf2_ros::StaticTransformBroadcaster>();
  broadcaster->sendTransform(message);
}

}  // namespace mixed_palletizing::adapters
