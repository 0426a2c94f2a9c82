#include <algorithm>

#include <mixed_palletizing/planning/gripper_envelope.hpp>

namespace mixed_palletizing::planning {
namespace {

/// Twice the distance of two centres along an axis is less than the sum of the lengths.
bool overlap(int begin_a, int length_a, int begin_b, int length_b, int size_a) {
  return std::abs(2 * begin_a + length_a - 2 * begin_b - length_b) < size_a + length_b;
}

}  // namespace

std::vector<std::string> problems(const GripperEnvelope& envelope) {
  std::vector<std::string> found;
  const auto check = [&found](const char* name, int value) {
    if (value >= 0 && value <= packing::kMaxPalletLength) return;
    found.push_back(std::string(name) + ": " + std::to_string(value) + " mm: must lie in 0 .. " +
                    std::to_string(packing::kMaxPalletLength));
  };
  check("size_x", envelope.size_x);
  check("size_y", envelope.size_y);
  check("reach", envelope.reach);
  return found;
}

bool clears(const GripperEnvelope& envelope, const packing::PalletState& pallet,
            const packing::Placement& p) {
  if (!envelope.isThere()) return true;
  const int bottom = p.origin.z + p.size.z - envelope.reach;
  return std::none_of(pallet.placements().begin(), pallet.placements().end(),
                      [&](const packing::Placement& other) {
                        return other.origin.z + other.size.z > bottom &&
                               overlap(p.origin.x, p.size.x, other.origin.x, other.size.x, envelope.size_x) &&
                               overlap(p.origin.y, p.size.y, other.origin.y, other.size.y, envelope.size_y);
                      });
}

}  // namespace mixed_palletizing::planning
