// YAML from files, with limits: a library of its own, as options are read without the simulation too.
#pragma once

#include <cstddef>
#include <string>

#include <yaml-cpp/yaml.h>

namespace mixed_palletizing::simulation {

constexpr std::size_t kMaxYamlBytes = 16U << 20U;
constexpr int kMaxYamlDepth = 32;         ///< lists and maps within each other
constexpr int kMaxYamlValues = 1000000;   ///< in one file
constexpr std::size_t kMaxMistakes = 20;  ///< that an error message lists

/// A file's whole text. Throws std::runtime_error "path: cannot be read: why", also for more than kMaxYamlBytes.
std::string readYamlText(const std::string& path);

/// The first document of a text. Throws YAML::ParserException for what is no YAML or beyond the limits. yaml-cpp itself
/// calls itself for each level, so that a deep text would end the process.
YAML::Node parseYamlText(const std::string& text);

}  // namespace mixed_palletizing::simulation
