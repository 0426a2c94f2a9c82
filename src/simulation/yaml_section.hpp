// Reading a YAML map key by key; every mistake is kept with its line.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <yaml-cpp/yaml.h>

#include <mixed_palletizing/simulation/texture.hpp>

namespace mixed_palletizing::simulation {

/// Mistakes of one file, and where its keys stand.
class YamlReport {
 public:
  explicit YamlReport(std::string path) : path_(std::move(path)) {}

  void know(const std::string& key, const YAML::Node& node) { lines_[key] = node.Mark().line + 1; }

  /// Adds "key: what" at the line of the key or, if that is not in the file, of the nearest key around it.
  void add(const std::string& key, const std::string& what);

  /// A file that the scene file names: relative to its folder.
  std::string pathOf(const std::string& name) const;

  /// Throws std::invalid_argument with "file:line: key: what" lines in the order of the file, if there are any.
  void throwIfAny() const;

 private:
  std::string path_;
  std::map<std::string, int> lines_;
  std::multimap<int, std::string> mistakes_;  // by line
};

/// One map of the file. An absent map reads as empty: every value keeps its default.
class YamlSection {
 public:
  YamlSection(const YAML::Node& node, const std::string& key, YamlReport& report);

  /// Values replace the defaults in the arguments; a wrong type is reported and leaves the default.
  void read(const std::string& name, bool& value);
  void read(const std::string& name, int& value);
  void read(const std::string& name, std::uint32_t& value);
  void read(const std::string& name, double& value);
  void read(const std::string& name, std::string& value);
  void read(const std::string& name, Eigen::Vector2d& value);
  void read(const std::string& name, Eigen::Vector3d& value);
  void read(const std::string& name, Eigen::Matrix4d& value);              // rows
  void read(const std::string& name, std::vector<int>& values);            // a list, or one
  void read(const std::string& name, std::vector<std::uint32_t>& values);  // likewise

  /// An angle [rad] from the key `name`_deg.
  void readAngle(const std::string& name, double& value_rad);

  /// Colours of a picture file that the key names, null without the key.
  std::shared_ptr<const Texture> readTexture(const std::string& name);

  /// Path of the file that the key names, as the scene file stands; empty without the key.
  std::string readPath(const std::string& name);

  bool has(const std::string& name) const;
  YamlSection section(const std::string& name);

  /// The maps of a list.
  std::vector<YamlSection> list(const std::string& name);

  /// The node of a key, without marking it as read.
  YAML::Node peek(const std::string& name) const;

  /// Marks a key as read and returns its node.
  YAML::Node take(const std::string& name);

  /// Reports every key that nobody has read.
  void finish() const;

  void add(const std::string& name, const std::string& what) { report_->add(keyOf(name), what); }

 private:
  std::string keyOf(const std::string& name) const { return key_.empty() ? name : key_ + "." + name; }
  bool readNumbers(const std::string& name, const YAML::Node& node, std::size_t count, double* values);
  template <typename T>
  void readScalar(const std::string& name, T& value, const char* type);
  template <typename T>
  void readList(const std::string& name, std::vector<T>& values, const char* type);

  YAML::Node node_;
  std::string key_;
  YamlReport* report_;
  std::set<std::string> read_;
};

}  // namespace mixed_palletizing::simulation
