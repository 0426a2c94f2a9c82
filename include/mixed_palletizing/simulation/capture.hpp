// One capture of a scene: ray casting with Embree, then the sensor's noise.
#pragma once

#include <cstdint>
#include <vector>

#include <mixed_palletizing/geometry/organized_cloud.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

struct Capture {
  geometry::OrganizedCloud cloud;
  /// Row-major, also where the cloud has no data: 0 = floor, surfaces, nothing; i + 1 = scene.boxes[i]; after the
  /// boxes come scene.objects.
  std::vector<std::uint16_t> mask;
  std::vector<std::size_t> visible_pixels;         ///< per box: pixels of the mask
  std::vector<std::size_t> object_visible_pixels;  ///< per object, likewise
  /// Per box: pixels of its top in the image over those that it would have alone before an unlimited image,
  /// [0, 1]. Geometry only: pixels without data count as seen.
  std::vector<double> top_visibility;
};

/// Cloud of the scene as its camera sees it, in the optical frame. The same scene and seed give the same
/// bytes, whatever the number of threads. O(pixels * log(triangles)).
/// Throws std::invalid_argument with every line of problems(scene), or for threads < 1.
Capture capture(const Scene& scene, std::uint64_t seed, int threads = 1);

}  // namespace mixed_palletizing::simulation
