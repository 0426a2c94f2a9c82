// Scenes as YAML files.
#pragma once

#include <string>

#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

/// Reads a scene; keys nobody knows, wrong types and values out of range are errors.
/// Throws std::invalid_argument with "file:line: key: what is wrong" lines, std::runtime_error when
/// unreadable.
Scene loadScene(const std::string& path);

}  // namespace mixed_palletizing::simulation
