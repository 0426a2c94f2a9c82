#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <mixed_palletizing/adapters/option_reader.hpp>
#include <mixed_palletizing/simulation/yaml_text.hpp>

namespace mixed_palletizing::adapters {
namespace {

// Longest texts in a message: a key or value may be as long as the file.
constexpr std::size_t kMaxQuote = 80;
constexpr std::size_t kMaxProblem = 2000;

std::string shortened(const std::string& text, std::size_t length) {
  return text.size() <= length ? text : text.substr(0, length) + "...";
}

/// Levenshtein distance, for the hint at a misspelt key.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

std::string hint(const std::string& key, const std::set<std::string>& known) {
  if (key.size() > kMaxQuote) return "";
  const std::string* best = nullptr;
  std::size_t best_distance = std::max<std::size_t>(3, key.size() / 3 + 1);
  for (const std::string& candidate : known) {
    const std::size_t distance = editDistance(key, candidate);
    if (distance < best_distance) {
      best = &candidate;
      best_distance = distance;
    }
  }
  return best ? " (did you mean '" + *best + "'?)" : "";
}

bool isFinite(double value) { return std::isfinite(value); }
bool isFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}
template <typename T>
bool isFinite(const T&) {
  return true;
}

std::string itemKey(const std::string& key, std::size_t i) { return key + "[" + std::to_string(i) + "]"; }

std::string textOf(const YAML::Node& node) {
  YAML::Emitter emitter;
  emitter << YAML::Flow << node;
  return shortened(emitter.c_str(), kMaxQuote);
}

}  // namespace

struct OptionReader::Shared {
  YAML::Node root;
  std::vector<std::string> problems;
  std::map<std::string, std::set<std::string>> known;  // keys asked for, by section path
  std::set<std::string> ignored;                       // full paths

  void listUnread(const YAML::Node& node, const std::string& path, std::vector<std::string>& out) const {
    if (!node.IsMap()) return;
    const auto section = known.find(path);
    if (section == known.end()) return;
    for (const auto& entry : node) {
      const std::string key = entry.first.as<std::string>("");
      if (ignored.count(path + key) > 0) continue;
      if (section->second.count(key) == 0) {
        out.push_back(path + key + ": nobody knows this key" + hint(key, section->second));
      } else if (entry.second.IsSequence()) {
        for (std::size_t i = 0; i < entry.second.size(); ++i) {
          listUnread(entry.second[i], path + itemKey(key, i) + ".", out);
        }
      } else {
        listUnread(entry.second, path + key + ".", out);
      }
    }
  }
};

OptionReader::OptionReader(const YAML::Node& tree) : OptionReader(tree, "", std::make_shared<Shared>()) {
  shared_->root = tree;
  if (!tree.IsNull() && !tree.IsMap()) shared_->problems.push_back("a group of 'key: value' is expected");
}

OptionReader::OptionReader(const YAML::Node& node, const std::string& path, std::shared_ptr<Shared> shared)
    : node_(node), path_(path), shared_(std::move(shared)) {
  shared_->known[path_];
}

YAML::Node OptionReader::find(const std::string& key) {
  shared_->known[path_].insert(key);
  if (!node_.IsMap()) return YAML::Node(YAML::NodeType::Undefined);
  const YAML::Node& constant = node_;  // the non-const operator would insert the key
  return constant[key];
}

template <typename T>
void OptionReader::readAs(const std::string& key, T& value, const char* type) {
  const YAML::Node found = find(key);
  if (!found.IsDefined()) return;
  try {
    const T read = found.as<T>();
    if (isFinite(read)) {
      value = read;
      return;
    }
  } catch (const YAML::Exception&) {
    // Reported below, with what was found instead.
  }
  shared_->problems.push_back(path_ + key + ": " + textOf(found) + " is not " + type);
}

void OptionReader::read(const std::string& key, bool& value) { readAs(key, value, "true or false"); }
void OptionReader::read(const std::string& key, int& value) { readAs(key, value, "a whole number"); }
void OptionReader::read(const std::string& key, std::uint64_t& value) {
  readAs(key, value, "a whole number from 0");
}
void OptionReader::read(const std::string& key, double& value) { readAs(key, value, "a finite number"); }
void OptionReader::read(const std::string& key, std::string& value) { readAs(key, value, "a text"); }
void OptionReader::read(const std::string& key, std::vector<int>& value) {
  readAs(key, value, "a list of whole numbers");
}
void OptionReader::read(const std::string& key, std::vector<double>& value) {
  readAs(key, value, "a list of finite numbers");
}

std::size_t OptionReader::readChoice(const std::string& key, const std::vector<std::string>& choices) {
  const YAML::Node found = find(key);
  if (!found.IsDefined()) return choices.size();
  const std::string word = found.IsScalar() ? found.as<std::string>() : textOf(found);
  const auto match = std::find(choices.begin(), choices.end(), word);
  if (match == choices.end()) {
    std::string list;
    for (const std::string& choice : choices) list += (list.empty() ? "" : ", ") + choice;
    shared_->problems.push_back(path_ + key + ": '" + word + "' is none of: " + list);
  }
  return static_cast<std::size_t>(match - choices.begin());
}

OptionReader OptionReader::section(const std::string& key) {
  const YAML::Node found = find(key);
  if (found.IsDefined() && !found.IsMap() && !found.IsNull()) {
    shared_->problems.push_back(path_ + key + ": a group of 'key: value' is expected");
  }
  return OptionReader(found.IsDefined() ? found : YAML::Node(), path_ + key + ".", shared_);
}

std::vector<OptionReader> OptionReader::items(const std::string& key) {
  std::vector<OptionReader> readers;
  const YAML::Node found = find(key);
  if (!found.IsDefined() || found.IsNull()) return readers;
  if (!found.IsSequence()) {
    shared_->problems.push_back(path_ + key + ": a list of groups is expected");
    return readers;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::string path = path_ + itemKey(key, i) + ".";
    if (!found[i].IsMap())
      shared_->problems.push_back(path_ + itemKey(key, i) + ": a group of 'key: value' is expected");
    readers.push_back(OptionReader(found[i], path, shared_));
  }
  return readers;
}

void OptionReader::ignore(const std::string& key) { shared_->ignored.insert(path_ + key); }

void OptionReader::add(const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) shared_->problems.push_back(path_ + problem);
}

std::vector<std::string> OptionReader::problems() const {
  std::vector<std::string> all = shared_->problems;
  shared_->listUnread(shared_->root, "", all);
  return all;
}

void OptionReader::finish(const std::string& what) const {
  const std::vector<std::string> all = problems();
  if (all.empty()) return;
  std::string text =
      what + ": " + std::to_string(all.size()) + (all.size() == 1 ? " mistake:" : " mistakes:");
  const std::size_t told = std::min(all.size(), simulation::kMaxMistakes);
  for (std::size_t i = 0; i < told; ++i) text += "\n  " + shortened(all[i], kMaxProblem);
  if (told < all.size()) text += "\n  and " + std::to_string(all.size() - told) + " more";
  throw std::invalid_argument(text);
}

YAML::Node loadYaml(const std::string& path) {
  try {
    return simulation::parseYamlText(simulation::readYamlText(path));
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace mixed_palletizing::adapters
