// A cuboid that moves by v while another rests touches it when the line from its centre to centre + v enters the
// cuboid grown by half the moving one's size (Minkowski sum; the line is cut with its three pairs of planes).
#include <algorithm>
#include <array>
#include <limits>

#include <mixed_palletizing/planning/approach.hpp>

namespace mixed_palletizing::planning {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// Open cuboid.
struct Cuboid {
  std::array<double, 3> min;
  std::array<double, 3> max;
};

Cuboid cuboidOf(const packing::Placement& p) {
  return {{1.0 * p.origin.x, 1.0 * p.origin.y, 1.0 * p.origin.z},
          {1.0 * p.origin.x + p.size.x, 1.0 * p.origin.y + p.size.y, 1.0 * p.origin.z + p.size.z}};
}

Cuboid gripperOver(const GripperEnvelope& gripper, const packing::Placement& p) {
  const double x = p.origin.x + 0.5 * p.size.x;
  const double y = p.origin.y + 0.5 * p.size.y;
  return {{x - 0.5 * gripper.size_x, y - 0.5 * gripper.size_y, 1.0 * p.origin.z + p.size.z - gripper.reach},
          {x + 0.5 * gripper.size_x, y + 0.5 * gripper.size_y, kNoEnd}};
}

/// Moved by `from` it comes back to where it is in a straight line: does it touch `other` on the way?
bool touches(const Cuboid& moving, const std::array<double, 3>& from, const Cuboid& other) {
  double begin = 0.0;  // of the part of the way, from the place (0) to `from` (1), where they overlap
  double end = 1.0;
  for (std::size_t axis = 0; axis < from.size(); ++axis) {
    const double low = other.min[axis] - moving.max[axis];  // moved by more than this,
    const double high =
        other.max[axis] - moving.min[axis];  // and less than this, they overlap along the axis
    if (from[axis] == 0.0) {
      if (low >= 0.0 || high <= 0.0) return false;
      continue;
    }
    const double a = low / from[axis];
    const double b = high / from[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin < end;
}

Cuboid movedAndUpwards(Cuboid cuboid, const std::array<double, 3>& by) {
  for (std::size_t axis = 0; axis < by.size(); ++axis) {
    cuboid.min[axis] += by[axis];
    cuboid.max[axis] += by[axis];
  }
  cuboid.max[2] = kNoEnd;
  return cuboid;
}

bool isFree(const std::vector<Cuboid>& moving, const std::array<double, 3>& from,
            const packing::PalletState& pallet) {
  return std::none_of(pallet.placements().begin(), pallet.placements().end(),
                      [&](const packing::Placement& placed) {
                        const Cuboid other = cuboidOf(placed);
                        return std::any_of(moving.begin(), moving.end(), [&](const Cuboid& cuboid) {
                          return touches(cuboid, from, other) ||
                                 touches(movedAndUpwards(cuboid, from), {0.0, 0.0, 0.0}, other);
                        });
                      });
}

/// The sideways part along an axis: towards the free side when only the other has a neighbour.
double awayFromNeighbours(const packing::PalletState& pallet, const Cuboid& box, std::size_t axis,
                          double sideways) {
  std::array<bool, 2> stands{false, false};  // on the lower, on the upper side
  for (const packing::Placement& placed : pallet.placements()) {
    const Cuboid other = cuboidOf(placed);
    const std::size_t across = 1 - axis;
    if (other.max[2] <= box.min[2] || other.max[across] <= box.min[across] ||
        other.min[across] >= box.max[across]) {
      continue;
    }
    const double below = box.min[axis] - other.max[axis];
    const double above = other.min[axis] - box.max[axis];
    stands[0] = stands[0] || (below >= 0.0 && below < sideways);
    stands[1] = stands[1] || (above >= 0.0 && above < sideways);
  }
  if (stands[0] == stands[1]) return 0.0;
  return stands[0] ? sideways : -sideways;
}

}  // namespace

std::vector<std::string> problems(const ApproachOptions& options) {
  std::vector<std::string> found;
  const auto check = [&found](const char* name, int value) {
    if (value >= 0 && value <= packing::kMaxPalletLength) return;
    found.push_back(std::string(name) + ": " + std::to_string(value) + " mm: must lie in 0 .. " +
                    std::to_string(packing::kMaxPalletLength));
  };
  check("sideways", options.sideways);
  check("height", options.height);
  return found;
}

packing::Vec3 lastStretch(const ApproachOptions& options, const GripperEnvelope& gripper,
                          const packing::PalletState& pallet, const packing::Placement& placement) {
  if (options.sideways == 0 || options.height == 0) return {};
  std::vector<Cuboid> moving{cuboidOf(placement)};
  if (gripper.isThere()) moving.push_back(gripperOver(gripper, placement));
  const double x = awayFromNeighbours(pallet, moving.front(), 0, options.sideways);
  const double y = awayFromNeighbours(pallet, moving.front(), 1, options.sideways);
  const std::array<std::array<double, 2>, 3> wishes{{{x, y}, {x, 0.0}, {0.0, y}}};
  for (const auto& [from_x, from_y] : wishes) {
    if (from_x == 0.0 && from_y == 0.0) continue;
    if (!isFree(moving, {from_x, from_y, 1.0 * options.height}, pallet)) continue;
    return {static_cast<int>(-from_x), static_cast<int>(-from_y), -options.height};
  }
  return {};
}

}  // namespace mixed_palletizing::planning
