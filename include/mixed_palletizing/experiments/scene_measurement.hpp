// Simulates a scene, detects in it and compares with the truth.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/experiments/box_errors.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace mixed_palletizing::experiments {

/// One true box and what became of it.
struct BoxRecord {
  TrueBox truth;
  std::optional<detection::DetectedBox> found;
  BoxErrors errors;  ///< only when found
};

struct SceneRecord {
  std::uint64_t index = 0;
  bool base_found = false;
  std::string base_message;  ///< why it was not found
  BaseFrameErrors base;
  std::vector<BoxRecord> boxes;
  std::vector<detection::DetectedBox> invented;                  ///< detections that are no box of the scene
  std::vector<std::array<Eigen::Vector2d, 4>> found_corners_px;  ///< tops of boxes[i].found
  std::vector<std::array<Eigen::Vector2d, 4>> invented_corners_px;  ///< tops of invented[i]
  std::vector<std::string> refusals;  ///< "reason: text" of every rejected cluster
  double base_ms = 0.0;
  double detect_ms = 0.0;
};

enum class BaseSource {
  kMarker,  ///< found in the cloud: its errors are in those of the boxes
  kTruth,   ///< given: the boxes alone
};

struct MeasurementOptions {
  detection::DetectionOptions detection;
  BaseSource base = BaseSource::kMarker;
};

/// Scene and seed of its noise by index.
struct SceneSource {
  std::function<simulation::Scene(std::uint64_t index)> scene;
  std::function<std::uint64_t(std::uint64_t index)> noise_seed;
};

/// Scenes of a recipe by one seed.
SceneSource recipeSource(const simulation::Recipe& recipe, std::uint64_t seed);

/// One scene. `look` is called with the capture before it is thrown away, may be empty.
SceneRecord measureScene(const SceneSource& source, std::uint64_t index, const MeasurementOptions& options,
                         const std::function<void(const simulation::Capture&)>& look = nullptr);

/// Scenes [first, first + count) on `threads` threads, in their order. `done` is called after each, by one
/// thread at a time; may be empty. Times are those of scenes side by side. Throws what the first failing
/// scene threw.
std::vector<SceneRecord> measureScenes(const SceneSource& source, std::uint64_t first, std::uint64_t count,
                                       const MeasurementOptions& options, int threads,
                                       const std::function<void()>& done = nullptr);

}  // namespace mixed_palletizing::experiments
