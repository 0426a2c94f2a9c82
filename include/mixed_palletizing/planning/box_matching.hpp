// Which order line a detected box belongs to.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::planning {

/// A detected size [mm], length >= width, and its standard deviations.
struct MeasuredBox {
  std::array<double, 3> size_mm{};  ///< length, width, height
  std::array<double, 3> stddev_mm{};
};

struct MatchingOptions {
  double tolerance_mm = 10.0;  ///< a side may differ by this much whatever its stddev says
  double sigmas = 3.0;         ///< or by this many standard deviations
};

std::vector<std::string> problems(const MatchingOptions& options);

enum class MatchStatus { kMatched, kUnknown, kAmbiguous };

struct BoxMatch {
  MatchStatus status = MatchStatus::kUnknown;
  int type = -1;                ///< when matched
  std::vector<int> candidates;  ///< all types within tolerance
  std::string message;          ///< the nearest type and by how much it is missed, or the candidates
};

/// Compares with every type that has items left, standing on each side its rotations allow and turned about
/// the vertical at will (the robot grips it at any yaw). Two types within tolerance are ambiguous unless they
/// pack alike; of those that do, the first is matched. A measurement that is not positive and finite is
/// unknown. Throws std::invalid_argument when `remaining` is not one count per type.
BoxMatch matchBox(const MeasuredBox& box, const std::vector<packing::ItemType>& types,
                  const std::vector<int>& remaining, const MatchingOptions& options);

}  // namespace mixed_palletizing::planning
