#include <algorithm>
#include <map>
#include <stdexcept>

#include <mixed_palletizing/instances/files.hpp>

#include "instance_json.hpp"
#include "text_lines.hpp"

namespace mixed_palletizing::instances {
namespace {

constexpr std::size_t kMaxJoined = 10;
constexpr std::size_t kMaxFault = 1000;  ///< of one: a name may be as long as the file

std::string resultName(const Json& line) {
  if (line.is_object() && line.contains("name") && line["name"].is_string()) return line["name"];
  throw std::invalid_argument("name: a string is needed");
}

template <typename File>
std::vector<Instance> wholeFile(File file) {
  throwFaults(file.faults);
  return std::move(file.instances);
}

}  // namespace

std::string joinFaults(const std::vector<std::string>& faults) {
  std::string text;
  for (std::size_t i = 0; i < faults.size() && i < kMaxJoined; ++i) {
    text +=
        (i > 0 ? "; " : "") + faults[i].substr(0, kMaxFault) + (faults[i].size() > kMaxFault ? "..." : "");
  }
  if (faults.size() > kMaxJoined) text += "; and " + std::to_string(faults.size() - kMaxJoined) + " more";
  return text;
}

const PackingResult* ResultFile::find(const std::string& name) const {
  const auto found = std::find_if(results.begin(), results.end(),
                                  [&name](const auto& result) { return result.name == name; });
  return found == results.end() ? nullptr : &*found;
}

InstanceFile readInstanceFile(const std::string& path) {
  InstanceFile file;
  std::map<std::string, int> line_of;
  forEachLine(path, file.faults, [&](const std::string& line, int number, std::vector<std::string>& faults) {
    Instance instance = instanceFromJson(parseStrictJson(line), faults);
    if (!faults.empty()) return;
    const auto [first, is_new] = line_of.emplace(instance.name, number);
    if (is_new) {
      file.instances.push_back(std::move(instance));
    } else {
      faults.push_back("name: '" + instance.name + "' is also that of line " + std::to_string(first->second));
    }
  });
  return file;
}

ResultFile readResultFile(const std::string& path, const std::vector<Instance>& instances) {
  ResultFile file;
  std::map<std::string, const Instance*> by_name;
  for (const Instance& instance : instances) by_name.emplace(instance.name, &instance);
  std::map<std::string, int> line_of;
  forEachLine(path, file.faults, [&](const std::string& line, int number, std::vector<std::string>& faults) {
    const Json value = parseStrictJson(line);
    const std::string name = resultName(value);
    const auto instance = by_name.find(name);
    if (instance == by_name.end()) {
      faults.push_back("name: '" + name + "' is that of no instance");
      return;
    }
    const auto [first, is_new] = line_of.emplace(name, number);
    if (!is_new) {
      faults.push_back("name: '" + name + "' has a result in line " + std::to_string(first->second) +
                       " already");
      return;
    }
    PackingResult result = resultFromJson(value, *instance->second, faults);
    if (faults.empty()) file.results.push_back(std::move(result));
  });
  return file;
}

std::vector<Instance> readInstances(const std::string& path) { return wholeFile(readInstanceFile(path)); }
std::vector<Instance> readBrInstances(const std::string& path) { return wholeFile(readBrFile(path)); }

}  // namespace mixed_palletizing::instances
