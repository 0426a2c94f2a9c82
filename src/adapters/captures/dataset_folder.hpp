// The folder of a data set: its manifest and which scenes are there.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/adapters/captures/dataset.hpp>

namespace mixed_palletizing::captures {

/// Holds the folder for one run.
class DatasetFolder {
 public:
  /// Opens the folder, writes or compares its manifest, and removes what an ended run left unfinished. Throws as
  /// writeDataset() does.
  explicit DatasetFolder(const DatasetOptions& options);
  ~DatasetFolder();
  DatasetFolder(const DatasetFolder&) = delete;
  DatasetFolder& operator=(const DatasetFolder&) = delete;

  bool has(int index) const;

  /// An empty folder to write the files of a scene to.
  std::string begin(int index) const;

  /// Gives the folder the scene's name.
  void finish(int index) const;

 private:
  void lock();
  void checkManifest(const DatasetOptions& options) const;
  void removeUnfinished() const;

  std::string path_;
  int lock_ = -1;
};

}  // namespace mixed_palletizing::captures
