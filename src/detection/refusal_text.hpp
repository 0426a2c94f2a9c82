// Texts of refusals.
#pragma once

#include <cstdio>
#include <string>

namespace mixed_palletizing::detection {

/// printf into a string, cut after 159 characters.
template <typename... Values>
std::string text(const char* format, Values... values) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

}  // namespace mixed_palletizing::detection
