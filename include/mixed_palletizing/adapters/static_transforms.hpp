// The one broadcaster of static transforms of this process.
#pragma once

#include <string>

#include <ros/time.h>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::adapters {

/// Publishes parent_from_child on /tf_static; a later one for the same child replaces it. All nodelets of a
/// process share one latched publisher: with several, late listeners get the last message of only one.
void publishStaticTransform(const std::string& parent, const std::string& child,
                            const geometry::Pose& parent_from_child, const ros::Time& stamp);

}  // namespace mixed_palletizing::adapters
