#include <cmath>
#include <stdexcept>
#include <string>

#include <mixed_palletizing/adapters/units.hpp>

namespace mixed_palletizing::adapters {
namespace {

double checkedMillimeters(const char* function, double meters) {
  if (!isLength(meters)) {
    throw std::invalid_argument(std::string(function) + ": meters: " + std::to_string(meters) +
                                " m is no length up to 1000 m");
  }
  return meters * kMillimetersPerMeter;
}

}  // namespace

bool isLength(double meters) { return std::isfinite(meters) && std::abs(meters) <= kMaxLengthM; }

int millimetersUp(double meters) {
  return static_cast<int>(std::ceil(checkedMillimeters("millimetersUp", meters) - kUnitNoiseMm));
}

int millimetersDown(double meters) {
  return static_cast<int>(std::floor(checkedMillimeters("millimetersDown", meters) + kUnitNoiseMm));
}

int millimetersNearest(double meters) {
  return static_cast<int>(std::lround(checkedMillimeters("millimetersNearest", meters)));
}

}  // namespace mixed_palletizing::adapters
