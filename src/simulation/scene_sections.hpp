// Sections of a scene file; every one reads its keys and reports those it does not know.
#pragma once

#include <mixed_palletizing/simulation/scene.hpp>

#include "yaml_section.hpp"

namespace mixed_palletizing::simulation {

/// Reads the pose only if asked. Returns whether the camera is the ideal one, which has no noise (and no projector).
bool readCamera(YamlSection section, bool with_pose, Camera& camera);

void readMarker(YamlSection section, Marker& marker);
void readBoard(YamlSection section, MarkerBoard& board);
void readBox(YamlSection section, SceneBox& box);
void readSurface(YamlSection section, SceneSurface& surface);
void readObject(YamlSection section, SceneObject& object);

}  // namespace mixed_palletizing::simulation
