#include "dataset_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include "whole_file.hpp"

namespace mixed_palletizing::captures {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char kManifest[] = "manifest.json";
constexpr char kUnfinished[] = ".unfinished";  // ending of files and folders that are being written
constexpr int kVersion = 1;

std::string readText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad())
    throw std::runtime_error(path + ": cannot read: " + std::strerror(errno));
  return text.str();
}

/// What all scenes of the folder have in common.
json manifestOf(const DatasetOptions& options) {
  json manifest;
  manifest["version"] = kVersion;
  manifest["recipe"] = fs::path(options.recipe).stem().string();
  manifest["recipe_yaml"] = readText(options.recipe);
  manifest["seed"] = options.seed;
  manifest["cloud"] = options.cloud;
  manifest["layout"] = options.layout
                           ? adapters::cloudLayoutNames()[static_cast<std::size_t>(*options.layout)]
                           : std::string("default");
  manifest["bag"] = options.bag;
  return manifest;
}

bool isUnfinished(const fs::path& path) {
  const std::string name = path.filename().string();
  const std::size_t length = std::strlen(kUnfinished);
  return name.size() > length && name.compare(name.size() - length, length, kUnfinished) == 0;
}

bool isEmpty(const std::string& path) {
  const fs::directory_iterator entries(path);
  return std::all_of(fs::begin(entries), fs::end(entries),
                     [](const fs::directory_entry& entry) { return isUnfinished(entry.path()); });
}

}  // namespace

DatasetFolder::DatasetFolder(const DatasetOptions& options) : path_(options.out) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw std::runtime_error(path_ + ": cannot make the folder: " + error.message());
  lock();
  try {
    checkManifest(options);
    removeUnfinished();
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

DatasetFolder::~DatasetFolder() { ::close(lock_); }

void DatasetFolder::lock() {
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) throw std::runtime_error(path_ + ": cannot open the folder: " + std::strerror(errno));
  if (::flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(lock_);
  throw std::runtime_error(path_ + ": another run is writing to it");
}

void DatasetFolder::checkManifest(const DatasetOptions& options) const {
  const json wanted = manifestOf(options);
  const std::string path = path_ + "/" + kManifest;
  if (!fs::exists(path)) {
    if (!isEmpty(path_)) throw std::invalid_argument(path_ + ": is neither empty nor a data set");
    writeWholeFile(path + kUnfinished, wanted.dump(2, ' ', true, json::error_handler_t::replace) + "\n");
    fs::rename(path + kUnfinished, path);
    return;
  }
  json found;
  try {
    found = json::parse(readText(path));
  } catch (const json::exception& error) {
    throw std::invalid_argument(path + ": is no manifest of a data set: " + error.what());
  }
  for (const auto& entry : wanted.items()) {
    const json value = found.is_object() ? found.value(entry.key(), json()) : json();
    if (value == entry.value()) continue;
    const bool is_text = entry.key() == "recipe_yaml";
    throw std::invalid_argument(
        path_ + ": holds a data set of another " +
        (is_text ? "text of the recipe"
                 : entry.key() + " (" + value.dump() + ", not " + entry.value().dump() + ")") +
        "; continue it with its own options, or take another folder");
  }
}

void DatasetFolder::removeUnfinished() const {
  std::vector<fs::path> unfinished;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
    if (isUnfinished(entry.path())) unfinished.push_back(entry.path());
  }
  for (const fs::path& path : unfinished) fs::remove_all(path);
}

bool DatasetFolder::has(int index) const { return fs::exists(path_ + "/" + datasetSceneName(index)); }

std::string DatasetFolder::begin(int index) const {
  const std::string path = path_ + "/" + datasetSceneName(index) + kUnfinished;
  fs::remove_all(path);
  fs::create_directory(path);
  return path;
}

void DatasetFolder::finish(int index) const {
  const std::string path = path_ + "/" + datasetSceneName(index);
  fs::rename(path + kUnfinished, path);
}

std::string datasetSceneName(int index) {
  char name[16];
  std::snprintf(name, sizeof name, "%06d", index);
  return name;
}

}  // namespace mixed_palletizing::captures
