// Texts of refusals.
#pragma once

#include <cstdio>
#include <string>

namespace mixed_palletizing::detection {

/// printf into a string, cut after 159 characters.
template <typename First, typename... Rest>
std::string text(const char* format, First first, Rest... rest) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, format, first, rest...);
  return buffer;
}

inline std::string text(const char* words) { return words; }

}  // namespace mixed_palletizing::detection
