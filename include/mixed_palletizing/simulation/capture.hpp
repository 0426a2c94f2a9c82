// One capture of a scene: ray casting with Embree, then the sensor's noise.
#pragma once

#include <cstdint>
#include <vector>

#include <mixed_palletizing/geometry/organized_cloud.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

struct Capture {
  geometry::OrganizedCloud cloud;
  std::vector<std::uint16_t>
      mask;  ///< row-major: 0 = no box, i + 1 = scene.boxes[i]; also where the cloud has no data
  std::vector<std::size_t> visible_pixels;  ///< per box: pixels of the mask
  std::vector<double> top_visibility;       ///< per box: seen share of the top face's projection, [0, 1]
};

/// Cloud of the scene as its camera sees it. The same scene and seed give the same bytes.
/// Throws std::invalid_argument with every line of problems(scene).
Capture capture(const Scene& scene, std::uint64_t seed);

}  // namespace mixed_palletizing::simulation
