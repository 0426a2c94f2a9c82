#include "yaml_section.hpp"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <mixed_palletizing/simulation/yaml_text.hpp>

namespace mixed_palletizing::simulation {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

/// The key of the thing around: "boxes[2].size_m" -> "boxes[2]" -> "boxes" -> "".
std::string parentOf(const std::string& key) {
  const std::size_t end = key.find_last_of(".[");
  return end == std::string::npos ? std::string() : key.substr(0, end);
}

/// A key or value of a file may be as long as the file.
std::string shortened(const std::string& text) {
  constexpr std::size_t kMax = 300;
  return text.size() <= kMax ? text : text.substr(0, kMax) + "...";
}

}  // namespace

void YamlReport::add(const std::string& key, const std::string& what) {
  std::string known = key;
  while (!known.empty() && lines_.count(known) == 0) known = parentOf(known);
  const auto line = lines_.find(known);
  mistakes_.emplace(line == lines_.end() ? 1 : line->second, shortened(key) + ": " + shortened(what));
}

std::string YamlReport::pathOf(const std::string& name) const {
  return (std::filesystem::path(path_).parent_path() / name).lexically_normal().string();
}

void YamlReport::throwIfAny() const {
  if (mistakes_.empty()) return;
  std::string text;
  std::size_t left = mistakes_.size();
  for (const auto& [line, mistake] : mistakes_) {
    if (mistakes_.size() - left == kMaxMistakes) {
      text += "\nand " + std::to_string(left) + " more";
      break;
    }
    text += (text.empty() ? "" : "\n") + path_ + ":" + std::to_string(line) + ": " + mistake;
    --left;
  }
  throw std::invalid_argument(text);
}

YamlSection::YamlSection(const YAML::Node& node, const std::string& key, YamlReport& report)
    : node_(node.IsDefined() && node.IsMap() ? node : YAML::Node(YAML::NodeType::Map)),
      key_(key),
      report_(&report) {
  if (node.IsDefined() && !node.IsNull() && !node.IsMap()) {
    report.add(key.empty() ? "file" : key, "is no map of keys and values");
  }
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : std::string("(a list or map)");
    report.know(keyOf(name), entry.first);
    if (!seen.insert(name).second) report.add(keyOf(name), "given twice");
  }
}

YAML::Node YamlSection::peek(const std::string& name) const {
  const YAML::Node& node = node_;  // the const operator[] adds nothing
  return node[name];
}

bool YamlSection::has(const std::string& name) const { return peek(name).IsDefined(); }

YAML::Node YamlSection::take(const std::string& name) {
  read_.insert(name);
  return peek(name);
}

template <typename T>
void YamlSection::readScalar(const std::string& name, T& value, const char* type) {
  const YAML::Node node = take(name);
  if (!node.IsDefined()) return;
  try {
    value = node.as<T>();
  } catch (const YAML::Exception&) {
    add(name,
        (node.IsScalar() ? "'" + node.Scalar() + "'" : std::string("a list or map")) + " is no " + type);
  }
}

template <typename T>
void YamlSection::readList(const std::string& name, std::vector<T>& values, const char* type) {
  const YAML::Node node = take(name);
  if (!node.IsDefined()) return;
  try {
    values = node.IsSequence() ? node.as<std::vector<T>>() : std::vector<T>{node.as<T>()};
  } catch (const YAML::Exception&) {
    add(name, std::string("is no list of ") + type);
  }
}

void YamlSection::read(const std::string& name, std::vector<int>& values) {
  readList(name, values, "integers");
}
void YamlSection::read(const std::string& name, std::vector<std::uint32_t>& values) {
  readList(name, values, "colours 0xRRGGBB");
}
void YamlSection::read(const std::string& name, bool& value) { readScalar(name, value, "true or false"); }
void YamlSection::read(const std::string& name, int& value) { readScalar(name, value, "integer"); }
void YamlSection::read(const std::string& name, std::uint32_t& value) {
  readScalar(name, value, "colour 0xRRGGBB");
}
void YamlSection::read(const std::string& name, std::string& value) { readScalar(name, value, "text"); }
void YamlSection::read(const std::string& name, double& value) { readNumbers(name, take(name), 1, &value); }

bool YamlSection::readNumbers(const std::string& name, const YAML::Node& node, std::size_t count,
                              double* values) {
  if (!node.IsDefined()) return false;
  const bool one = count == 1;
  std::vector<double> numbers;
  try {
    if (one) {
      numbers.push_back(node.as<double>());
    } else if (node.IsSequence()) {
      for (const YAML::Node& entry : node) numbers.push_back(entry.as<double>());
    }
  } catch (const YAML::Exception&) {
    numbers.clear();
  }
  bool finite = numbers.size() == count;
  for (const double number : numbers) finite = finite && std::isfinite(number);
  if (!finite) {
    add(name, one ? "is no finite number" : "is no list of " + std::to_string(count) + " finite numbers");
    return false;
  }
  std::copy(numbers.begin(), numbers.end(), values);
  return true;
}

void YamlSection::read(const std::string& name, Eigen::Vector2d& value) {
  readNumbers(name, take(name), 2, value.data());
}

void YamlSection::read(const std::string& name, Eigen::Vector3d& value) {
  readNumbers(name, take(name), 3, value.data());
}

void YamlSection::read(const std::string& name, Eigen::Matrix4d& value) {
  const YAML::Node node = take(name);
  if (!node.IsDefined()) return;
  if (!node.IsSequence() || node.size() != 4) return add(name, "is no list of 4 rows");
  Eigen::Matrix4d matrix;
  for (std::size_t row = 0; row < 4; ++row) {
    Eigen::Vector4d numbers;
    if (!readNumbers(name, node[row], 4, numbers.data())) return;
    matrix.row(static_cast<Eigen::Index>(row)) = numbers.transpose();
  }
  value = matrix;
}

void YamlSection::readAngle(const std::string& name, double& value_rad) {
  const std::string name_deg = name + "_deg";
  const YAML::Node node = take(name_deg);
  if (!node.IsDefined()) return;
  report_->know(keyOf(name), node);
  double value_deg = 0.0;
  if (readNumbers(name_deg, node, 1, &value_deg)) value_rad = value_deg * kRadPerDeg;
}

std::string YamlSection::readPath(const std::string& name) {
  std::string file;
  read(name, file);
  if (!file.empty()) return report_->pathOf(file);
  if (has(name)) add(name, "names no file");
  return file;
}

std::shared_ptr<const Texture> YamlSection::readTexture(const std::string& name) {
  const std::string path = readPath(name);
  if (path.empty()) return nullptr;
  try {
    return loadTexture(path);
  } catch (const std::runtime_error& error) {
    add(name, error.what());
    return nullptr;
  }
}

YamlSection YamlSection::section(const std::string& name) { return {take(name), keyOf(name), *report_}; }

std::vector<YamlSection> YamlSection::list(const std::string& name) {
  std::vector<YamlSection> sections;
  const YAML::Node node = take(name);
  if (!node.IsDefined() || node.IsNull()) return sections;
  if (!node.IsSequence()) {
    add(name, "is no list");
    return sections;
  }
  for (std::size_t i = 0; i < node.size(); ++i) {
    const std::string key = keyOf(name) + "[" + std::to_string(i) + "]";
    report_->know(key, node[i]);
    sections.emplace_back(node[i], key, *report_);
  }
  return sections;
}

void YamlSection::finish() const {
  for (const auto& entry : node_) {
    const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : std::string("(a list or map)");
    if (read_.count(name) == 0) report_->add(keyOf(name), "is no known key");
  }
}

}  // namespace mixed_palletizing::simulation
