#include "outline_match.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rectangle_sides.hpp"

namespace mixed_palletizing::detection {

OutlineMatch matchOutline(const std::vector<OutlineSample>& samples, const geometry::Rectangle& rectangle,
                          double tolerance_m, double tolerance_px) {
  OutlineMatch match;
  const Axes axes(rectangle);
  double free = 0.0;
  for (const OutlineSample& sample : samples) {
    if (sample.across == Across::kOccluder) match.occluded_ratio += 1.0;
    if (sample.across == Across::kBorder) match.border_ratio += 1.0;
    if (sample.across != Across::kFree) continue;
    free += 1.0;
    const double tolerance = std::max(tolerance_m, tolerance_px * sample.pixel_m);
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector2d local = axes.local(sample.measured);
      if (std::abs(alongOf(i).dot(local)) > halfAlong(rectangle, i) + tolerance) continue;
      if (std::abs(kOutward[i].dot(local) - halfAcross(rectangle, i)) > tolerance) continue;
      match.on_sides_ratio += 1.0;
      break;
    }
  }
  const double all = std::max(1.0, static_cast<double>(samples.size()));
  match.occluded_ratio /= all;
  match.border_ratio /= all;
  match.on_sides_ratio /= std::max(1.0, free);
  return match;
}

}  // namespace mixed_palletizing::detection
