#include <cstdlib>
#include <stdexcept>
#include <string>

#include <XmlRpcValue.h>
#include <ros/names.h>

#include <mixed_palletizing/adapters/parameters.hpp>

namespace mixed_palletizing::adapters {
namespace {

/// Given on the command line by launch files, which put all other parameters on the server.
constexpr const char* kLaunched = "launched";

YAML::Node toYaml(XmlRpc::XmlRpcValue& value, const std::string& path) {
  YAML::Node node;
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      node = static_cast<bool>(value);
      break;
    case XmlRpc::XmlRpcValue::TypeInt:
      node = static_cast<int>(value);
      break;
    case XmlRpc::XmlRpcValue::TypeDouble:
      node = static_cast<double>(value);
      break;
    case XmlRpc::XmlRpcValue::TypeString:
      node = static_cast<std::string>(value);
      break;
    case XmlRpc::XmlRpcValue::TypeArray:
      node = YAML::Node(YAML::NodeType::Sequence);
      for (int i = 0; i < value.size(); ++i) {
        node.push_back(toYaml(value[i], path + "[" + std::to_string(i) + "]"));
      }
      break;
    case XmlRpc::XmlRpcValue::TypeStruct:
      node = YAML::Node(YAML::NodeType::Map);
      for (auto& entry : value) node[entry.first] = toYaml(entry.second, path + "/" + entry.first);
      break;
    default:
      throw std::invalid_argument("parameter " + path + " is neither number, text, list nor group");
  }
  return node;
}

}  // namespace

YAML::Node parameterTree(const ros::NodeHandle& private_node) {
  XmlRpc::XmlRpcValue tree;
  if (!private_node.getParam(private_node.getNamespace(), tree) ||
      tree.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
    return YAML::Node(YAML::NodeType::Map);
  }
  YAML::Node read = toYaml(tree, private_node.getNamespace());
  if (!read[kLaunched]) return read;
  read.remove(kLaunched);
  if (read.size() > 0) return read;
  throw std::runtime_error(
      "its parameters are gone: the ROS master that had them was started anew; start the launch file again");
}

std::string siblingName(const ros::NodeHandle& private_node, const std::string& name) {
  const std::string around = ros::names::parentNamespace(private_node.getNamespace());
  return private_node.resolveName(name.rfind('/', 0) == 0 ? name : ros::names::append(around, name));
}

std::string expandPath(const std::string& path) {
  if (path.rfind("~/", 0) != 0) return path;
  const char* home = std::getenv("HOME");
  if (home == nullptr) throw std::invalid_argument("path " + path + ": the environment has no HOME");
  return home + path.substr(1);
}

}  // namespace mixed_palletizing::adapters
