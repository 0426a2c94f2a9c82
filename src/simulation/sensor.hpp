// From ideal samples to the points that a structured-light sensor delivers.
#pragma once

#include <cstdint>
#include <vector>

#include <mixed_palletizing/simulation/scene.hpp>

#include "counter_random.hpp"

namespace mixed_palletizing::simulation {

/// What the ray of a pixel met.
struct Sample {
  double depth_m = 0.0;   ///< not above 0: nothing
  std::uint32_t rgb = 0;  ///< with light and shadow
  int object = -1;        ///< index of the object; -1: nothing
  std::uint8_t face = 0;  ///< of that object
  bool is_dark = false;   ///< ink that gives no data
  bool is_lit = true;     ///< by the projector
};

/// The row's depths as the sensor measures them, NaN for no data; `samples` is the whole image, row-major.
class Sensor {
 public:
  Sensor(const Noise& noise, int width, int height, std::uint64_t seed);

  double measuredDepth(const std::vector<Sample>& samples, int row, int col) const;

 private:
  double flyingDepth(const std::vector<Sample>& samples, int row, int col) const;

  Noise noise_;
  int width_;
  int height_;
  CounterRandom random_;
};

}  // namespace mixed_palletizing::simulation
