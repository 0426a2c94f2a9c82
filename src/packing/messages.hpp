// Error texts.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace mixed_palletizing::packing {

/// Throws std::invalid_argument with all `problems` behind `function`; does nothing when there are none.
inline void throwProblems(const std::string& function, const std::vector<std::string>& problems) {
  if (problems.empty()) return;
  std::string text = function + ":";
  for (const std::string& problem : problems) text += (text.back() == ':' ? " " : "; ") + problem;
  throw std::invalid_argument(text);
}

}  // namespace mixed_palletizing::packing
