// What scene files and recipes have in common.
#pragma once

#include <string>

#include <mixed_palletizing/simulation/scene.hpp>

#include "yaml_section.hpp"

namespace mixed_palletizing::simulation {

/// The file's YAML. Throws std::runtime_error when unreadable, std::invalid_argument "file:line: no YAML: ...".
YAML::Node parseYaml(const std::string& path);

/// Reads the sections floor, marker, camera (its pose only if asked) and noise.
void readSetting(YamlSection& file, bool with_camera_pose, Scene& scene);

}  // namespace mixed_palletizing::simulation
