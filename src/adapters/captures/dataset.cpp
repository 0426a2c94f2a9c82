#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <mixed_palletizing/adapters/captures/capture_files.hpp>
#include <mixed_palletizing/adapters/captures/dataset.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

#include "dataset_folder.hpp"

namespace mixed_palletizing::captures {
namespace {

constexpr int kMostScenes = 1000000;
constexpr int kMostThreads = 256;

void writeScene(const DatasetOptions& options, const simulation::Recipe& recipe, const DatasetFolder& folder,
                int index) {
  const auto number = static_cast<std::uint64_t>(index);
  const simulation::Scene scene = simulation::recipeScene(recipe, options.seed, number);
  const std::uint64_t noise_seed = simulation::recipeNoiseSeed(options.seed, number);
  const simulation::Capture capture = simulation::capture(scene, noise_seed);
  const std::string path = folder.begin(index) + "/";
  CaptureFiles files;
  files.cloud = path + "cloud." + options.cloud;
  files.color = path + "color.png";
  files.depth = path + "depth.tiff";
  files.mask = path + "mask.png";
  files.camera_info = path + "camera_info.yaml";
  files.truth = path + "truth.json";
  if (options.bag) files.bag = path + "capture.bag";
  files.layout = options.layout;
  files.bag_stamp_s = 1.0 + index;  // so that the bags of a set can be played in a row
  writeCaptureFiles(files, scene, capture, noise_seed);
  folder.finish(index);
}

/// Scenes done by several threads; the first error ends them all.
class Workers {
 public:
  Workers(const std::vector<int>& indices, const std::function<void(int)>& work,
          const std::function<void()>& done)
      : indices_(indices), work_(work), done_(done) {}

  void run(int threads) {
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back([this] { runOne(); });
    runOne();
    for (std::thread& other : others) other.join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void runOne() {
    for (std::size_t i = next_++; i < indices_.size(); i = next_++) {
      try {
        work_(indices_[i]);
        const std::lock_guard<std::mutex> lock(mutex_);
        done_();
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        next_ = indices_.size();
      }
    }
  }

  const std::vector<int>& indices_;
  const std::function<void(int)>& work_;
  const std::function<void()>& done_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;  // guards failure_ and the calls of done_
  std::exception_ptr failure_;
};

}  // namespace

std::vector<std::string> problems(const DatasetOptions& options) {
  std::vector<std::string> all;
  const auto require = [&](bool holds, const std::string& line) {
    if (!holds) all.push_back(line);
  };
  require(!options.recipe.empty(), "recipe: a file is needed");
  require(!options.out.empty(), "out: a folder is needed");
  require(options.count >= 1 && options.count <= kMostScenes,
          "count: " + std::to_string(options.count) + " is not in [1, " + std::to_string(kMostScenes) + "]");
  require(options.cloud == "pcd" || options.cloud == "ply",
          "cloud: '" + options.cloud + "' is neither pcd nor ply");
  require(options.threads >= 1 && options.threads <= kMostThreads,
          "threads: " + std::to_string(options.threads) + " is not in [1, 256]");
  return all;
}

DatasetResult writeDataset(const DatasetOptions& options, const std::function<void(int, int)>& progress) {
  std::string mistakes;
  for (const std::string& problem : problems(options)) mistakes += (mistakes.empty() ? "" : "; ") + problem;
  if (!mistakes.empty()) throw std::invalid_argument(mistakes);
  const simulation::Recipe recipe = simulation::loadRecipe(options.recipe);
  const DatasetFolder folder(options);
  std::vector<int> missing;
  for (int index = 0; index < options.count; ++index) {
    if (!folder.has(index)) missing.push_back(index);
  }
  DatasetResult result;
  result.found = options.count - static_cast<int>(missing.size());
  const std::function<void(int)> work = [&](int index) { writeScene(options, recipe, folder, index); };
  const std::function<void()> done = [&] {
    ++result.written;
    if (progress) progress(result.found + result.written, options.count);
  };
  if (progress) progress(result.found, options.count);
  Workers(missing, work, done).run(options.threads);
  return result;
}

}  // namespace mixed_palletizing::captures
