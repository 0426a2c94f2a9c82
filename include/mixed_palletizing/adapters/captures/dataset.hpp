// Data sets: many scenes of a recipe with their truth, in a folder (docs/datasets.md).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/cloud_layout.hpp>

namespace mixed_palletizing::captures {

struct DatasetOptions {
  std::string recipe;  ///< file
  std::string out;     ///< folder; made when it is not there
  int count = 1;       ///< scenes
  std::uint64_t seed = 1;
  std::string cloud = "pcd";                    ///< kind of cloud files: pcd or ply
  std::optional<adapters::CloudLayout> layout;  ///< see CaptureFiles
  bool bag = false;                             ///< a bag for each scene
  int threads = 2;  ///< scenes that are made at a time; their bytes do not depend on it
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const DatasetOptions& options);

struct DatasetResult {
  int found = 0;    ///< scenes that were there already
  int written = 0;  ///< scenes that were not
};

/// Writes the scenes that the folder does not have yet; a scene appears under its name only when it is whole, so
/// that a run that was ended anywhere is continued by the next one. `progress(done, total)` is called from one
/// thread at a time. Throws std::invalid_argument with every line of problems(options), for a broken recipe, or when
/// the folder holds other things or a data set of other options; std::runtime_error "PATH: reason" when something
/// cannot be written (what is there stays valid) or another run is writing.
DatasetResult writeDataset(const DatasetOptions& options, const std::function<void(int, int)>& progress);

/// Folder of a scene within the data set: "000012".
std::string datasetSceneName(int index);

}  // namespace mixed_palletizing::captures
