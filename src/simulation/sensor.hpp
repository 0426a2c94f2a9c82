// From ideal samples to the points that a structured-light sensor delivers.
#pragma once

#include <cstdint>
#include <vector>

#include <mixed_palletizing/simulation/scene.hpp>

#include "counter_random.hpp"

namespace mixed_palletizing::simulation {

/// What the ray of a pixel met.
struct Sample {
  double depth_m = 0.0;   ///< z of the point; without meaning when there is none
  std::uint32_t rgb = 0;  ///< with the scene's light
  int object = -1;        ///< index of the object; -1: the ray met nothing
  std::uint8_t face = 0;  ///< of that object
  bool is_lit = true;     ///< by the projector
  float luma = 1.0f;      ///< of the paint, [0, 1]
  float cosine = 1.0f;    ///< of the angle between the ray and the surface's normal, [0, 1]
};

class Sensor {
 public:
  Sensor(const Noise& noise, int width, int height, std::uint64_t seed);

  /// Depth [m] that the sensor delivers for a pixel, NaN for no data; `samples` is the whole image, row-major.
  double measuredDepth(const std::vector<Sample>& samples, int row, int col) const;

 private:
  double depthStddev(const Sample& sample, double depth) const;
  double flyingDepth(const std::vector<Sample>& samples, int row, int col) const;

  Noise noise_;
  int width_;
  int height_;
  CounterRandom random_;
};

}  // namespace mixed_palletizing::simulation
