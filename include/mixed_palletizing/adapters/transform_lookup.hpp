// Transforms from tf that are waited for on the steady clock.
#pragma once

#include <optional>
#include <string>

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

namespace mixed_palletizing::adapters {

/// A transform, or what tf says why there is none.
struct FoundTransform {
  std::optional<geometry_msgs::TransformStamped> transform;
  std::string problem;
};

/// Transform from `source` to `target` at `stamp` (zero = the latest), waiting for it at most `timeout_s` [s] of
/// the steady clock: tf's own timeout never ends while simulated time stands still. Somebody else must fill the
/// buffer meanwhile. Never throws for a transform that cannot be had, nor answers one that is not finite or no
/// rotation.
FoundTransform lookUpTransform(const tf2::BufferCore& buffer, const std::string& target,
                               const std::string& source, const ros::Time& stamp, double timeout_s);

}  // namespace mixed_palletizing::adapters
