// A node's private parameters as a tree that OptionReader reads.
#pragma once

#include <ros/node_handle.h>
#include <yaml-cpp/yaml.h>

namespace mixed_palletizing::adapters {

/// All parameters in the namespace of `private_node`, as they are on the parameter server now; an empty map
/// when there is none. Throws std::invalid_argument for a value of a type that no option has (a date, bytes).
/// A node that a launch file starts has the parameter `launched` from its command line, which is left out here:
/// when it is alone, a new master has come since, without the parameters that roslaunch gave the old one. Throws
/// std::runtime_error then, so that a node started again does not work with defaults.
YAML::Node parameterTree(const ros::NodeHandle& private_node);

/// Absolute name of `name` in the namespace around a node's private one, remapped as that node's names are. For
/// a nodelet: its public NodeHandle falls into the manager's namespace when its own is the global one.
std::string siblingName(const ros::NodeHandle& private_node, const std::string& name);

/// The path with a leading "~/" replaced by the home directory; others stay as they are. Throws
/// std::invalid_argument when there is no HOME.
std::string expandPath(const std::string& path);

}  // namespace mixed_palletizing::adapters
