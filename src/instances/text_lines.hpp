// Line-wise reading of text files with faults named by path and line.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace mixed_palletizing::instances {

constexpr std::size_t kMaxLineBytes = 64U << 20U;

/// Calls `read` for every line that is not blank, with its number from 1 and a list for its faults, which are
/// appended to `faults` with path and line. A std::invalid_argument of `read` is one fault. A line longer than
/// kMaxLineBytes is a fault and the end. Throws std::runtime_error when the file cannot be read.
void forEachLine(const std::string& path, std::vector<std::string>& faults,
                 const std::function<void(const std::string& line, int number,
                                          std::vector<std::string>& line_faults)>& read);

/// File name without folder and extension.
std::string stemOf(const std::string& path);

}  // namespace mixed_palletizing::instances
