// Kinds of cloud files.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace mixed_palletizing::adapters {

enum class CloudFileType : std::uint8_t { kPcd, kPly };

[[noreturn]] inline void fail(const std::string& path, const std::string& reason) {
  throw std::runtime_error(path + ": " + reason);
}

/// By the ending of the path. Throws std::runtime_error "PATH: reason" for others than .pcd and .ply.
CloudFileType cloudFileType(const std::string& path);

}  // namespace mixed_palletizing::adapters
