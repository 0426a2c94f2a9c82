// OpenCV's predefined marker dictionaries by name.
#pragma once

#include <optional>
#include <string>

namespace mixed_palletizing::detection {

/// Number of markers in a predefined dictionary; nothing for an unknown name.
std::optional<int> dictionarySize(const std::string& name);

/// OpenCV's number of a predefined dictionary; nothing for an unknown name.
std::optional<int> dictionaryNumber(const std::string& name);

}  // namespace mixed_palletizing::detection
