// What the sensor can do, measured in the cloud itself: point spacing, depth noise, roughness of the floor.
#pragma once

#include <mixed_palletizing/detection/options.hpp>

#include "base_cloud.hpp"

namespace mixed_palletizing::detection {

struct SensorNoise {
  double spacing_per_m = 0.0;   ///< distance of neighbouring rays at depth 1 m, the coarser image direction
  double depth_per_m2 = 0.0;    ///< standard deviation of the depth at 1 m; grows with the depth squared
  double scene_depth_m = 1.0;   ///< median depth of the scene
  double floor_stddev_m = 0.0;  ///< of the heights near the floor: noise and ripple together
  double ripple_m = 0.0;  ///< what the floor strays beyond the depth noise: errors that neighbouring points
                          ///< share, so that no mean removes them; they show at edges too

  double spacing(double depth_m) const { return spacing_per_m * depth_m; }
  double depth(double depth_m) const { return depth_per_m2 * depth_m * depth_m; }
};

/// Measures a grid of some ten thousand samples; robust against edges and against boxes on most of the floor.
/// Heights below `floor_band_m` count as floor. Values stay 0 where the cloud has too little data to tell.
SensorNoise measureNoise(const BaseCloud& cloud, double floor_band_m);

}  // namespace mixed_palletizing::detection
