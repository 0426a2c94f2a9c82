#include "whole_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace mixed_palletizing::captures {

void writeWholeFile(const std::string& path, const void* data, std::size_t bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot write: " + std::strerror(errno));
}

}  // namespace mixed_palletizing::captures
