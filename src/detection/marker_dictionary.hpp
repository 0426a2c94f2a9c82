// OpenCV's predefined marker dictionaries by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mixed_palletizing::detection {

/// Number of markers in a predefined dictionary; nothing for an unknown name.
std::optional<int> dictionarySize(const std::string& name);

/// OpenCV's number of a predefined dictionary; nothing for an unknown name.
std::optional<int> dictionaryNumber(const std::string& name);

/// Cells of a marker row by row, its black border included; true = white. Throws std::invalid_argument when there is no
/// such marker.
std::vector<bool> markerCells(const std::string& dictionary, int id);

}  // namespace mixed_palletizing::detection
