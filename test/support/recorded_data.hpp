// Recorded clouds and published instances that are not part of the package.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

namespace mixed_palletizing::test {

/// Path of a file of the data folder: $MIXED_PALLETIZING_DATA, or shared/data beside the source tree. Nothing, and
/// a line on stdout, when it is not there.
inline std::optional<std::string> recordedData(const std::string& file) {
  const char* chosen = std::getenv("MIXED_PALLETIZING_DATA");
  const std::filesystem::path folder =
      chosen != nullptr ? std::filesystem::path(chosen)
                        : std::filesystem::path(MIXED_PALLETIZING_SOURCE_DIR) / ".." / "shared" / "data";
  const std::filesystem::path path = folder / file;
  if (std::filesystem::exists(path)) return path.string();
  std::cout << "not there: " << path.string() << " (set MIXED_PALLETIZING_DATA)\n";
  return std::nullopt;
}

}  // namespace mixed_palletizing::test
