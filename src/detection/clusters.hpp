// Clusters of points above the floor, in one pass over the cloud (thesis 3.2.1 "Transformation", 3.2.2
// "Clustering").
#pragma once

#include <algorithm>
#include <cstddef>

#include <mixed_palletizing/detection/options.hpp>

#include "base_cloud.hpp"
#include "grid_runs.hpp"
#include "sensor_noise.hpp"

namespace mixed_palletizing::detection {

/// The cluster options, raised to what the sensor can resolve.
struct ClusterLimits {
  float low_m = 0.0f;          ///< heights up to this belong to the floor
  float high_m = 0.0f;         ///< heights from this on are ignored
  float distance_m = 0.0f;     ///< comparator between neighbours, at least
  float spacing_per_m = 0.0f;  ///< what the comparator grants to the spacing, at depth 1 m
  float noise_per_m2 = 0.0f;   ///< and to the depth noise
  float camera_height_m = 0.0f;
  WorkRegion region;  ///< points outside are ignored

  ClusterLimits(const DetectionOptions& options, const SensorNoise& noise, const BaseCloud& cloud);

  /// Square of the largest distance between neighbours of one surface, at depth z and height h [m]. Points of a
  /// level surface are stretched along the view by depth over height of the camera above it.
  float squaredDistance(float z, float h) const {
    const float stretch = std::min(kLargestStretch, z / std::max(camera_height_m - h, 1e-3f));
    const float distance = std::max(distance_m, z * (spacing_per_m * stretch + noise_per_m2 * z));
    return distance * distance;
  }

  // Seen at a flatter angle, neighbours of a level surface are no longer told from edges.
  static constexpr float kLargestStretch = 6.0f;
};

/// Fills `clusters` with the components of the points between the height limits; 4-connected grid neighbours
/// nearer than the comparator's distance belong together (eq. 3.8). Returns the number of points with data.
std::size_t findClusters(const BaseCloud& cloud, const ClusterLimits& limits, RunForest& clusters);

}  // namespace mixed_palletizing::detection
