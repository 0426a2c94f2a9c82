// Options from a tree of parameters (a YAML file or a node's private parameters): every mistake is collected.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace mixed_palletizing::adapters {

/// Reads members of option structs by key, the member's value being the default:
///
///   OptionReader reader(tree);
///   reader.read("time_budget_s", options.time_budget_s);
///   OptionReader plane = reader.section("plane");
///   plane.read("distance_m", options.plane.distance_m);
///   reader.add(problems(options));
///   reader.finish("the parameters of box_detector");
///
/// Wrong types, values that are not finite, and keys that nobody read become problems; finish() throws once
/// with all of them.
class OptionReader {
 public:
  explicit OptionReader(const YAML::Node& tree);

  void read(const std::string& key, bool& value);
  void read(const std::string& key, int& value);
  void read(const std::string& key, std::uint64_t& value);
  void read(const std::string& key, double& value);
  void read(const std::string& key, std::string& value);
  void read(const std::string& key, std::vector<int>& value);
  void read(const std::string& key, std::vector<double>& value);

  /// One word of `words`, each with the value it stands for.
  template <typename T>
  void readWord(const std::string& key, T& value, const std::vector<std::pair<std::string, T>>& words) {
    std::vector<std::string> choices;
    for (const auto& word : words) choices.push_back(word.first);
    const std::size_t index = readChoice(key, choices);
    if (index < words.size()) value = words[index].second;
  }

  /// The group of parameters at `key`; an empty one when the key is absent.
  OptionReader section(const std::string& key);

  /// The groups of the list at `key`; none when the key is absent.
  std::vector<OptionReader> items(const std::string& key);

  /// Marks a key as known to somebody else.
  void ignore(const std::string& key);

  /// Adds broken rules; each line starts with the key, relative to this section.
  void add(const std::vector<std::string>& problems);

  /// All that is wrong so far, unread keys of the whole tree included.
  std::vector<std::string> problems() const;

  /// Throws std::invalid_argument "WHAT: N mistakes:" and every problem in a line of its own.
  void finish(const std::string& what) const;

 private:
  struct Shared;
  OptionReader(const YAML::Node& node, const std::string& path, std::shared_ptr<Shared> shared);
  YAML::Node find(const std::string& key);
  std::size_t readChoice(const std::string& key, const std::vector<std::string>& choices);
  template <typename T>
  void readAs(const std::string& key, T& value, const char* type);

  YAML::Node node_;
  std::string path_;  // of this section with a trailing dot, empty for the root
  std::shared_ptr<Shared> shared_;
};

/// The tree of a YAML file. Throws std::runtime_error "PATH: reason" when it cannot be read or parsed.
YAML::Node loadYaml(const std::string& path);

}  // namespace mixed_palletizing::adapters
