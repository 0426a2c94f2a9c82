// Files that are written whole or give an error.
#pragma once

#include <string>

namespace mixed_palletizing::captures {

/// Throws std::runtime_error "PATH: cannot write: REASON", also when the disk is full.
void writeWholeFile(const std::string& path, const void* data, std::size_t bytes);

inline void writeWholeFile(const std::string& path, const std::string& text) {
  writeWholeFile(path, text.data(), text.size());
}

}  // namespace mixed_palletizing::captures
