// Validity of placements, worked out from the boxes alone.
//
// A box at height z is lowered past every box whose top is above z, wherever that box begins. So overlap,
// "nothing stands over it" and the gap are one question about footprints; they are told apart for the reader.
#include "placement_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace mixed_palletizing::instances {
namespace {

constexpr double kRounding = 1e-12;  ///< of a ratio in floating point

using packing::Placement;
using packing::Vec3;

int top(const Placement& p) { return p.origin.z + p.size.z; }

/// Whether the footprints come nearer than `gap` in x and in y.
bool footprintsMeet(const Placement& a, const Placement& b, int gap) {
  return a.origin.x < b.origin.x + b.size.x + gap && b.origin.x < a.origin.x + a.size.x + gap &&
         a.origin.y < b.origin.y + b.size.y + gap && b.origin.y < a.origin.y + a.size.y + gap;
}

std::string text(const Vec3& v) {
  return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
}

struct Rectangle {
  int x0, y0, x1, y1;
};

/// The parts of the base that lie on the pallet or on tops of exactly its height.
std::vector<Rectangle> contacts(const packing::PalletRules& rules, const Placement& placement,
                                const std::vector<Placement>& below) {
  std::vector<Rectangle> found;
  std::vector<Placement> supports;
  if (placement.origin.z == 0) supports.push_back({0, {0, 0, -1}, {rules.size.x, rules.size.y, 1}});
  for (const Placement& other : below) {
    if (top(other) == placement.origin.z) supports.push_back(other);
  }
  for (const Placement& other : supports) {
    if (!footprintsMeet(placement, other, 0)) continue;
    found.push_back({std::max(placement.origin.x, other.origin.x),
                     std::max(placement.origin.y, other.origin.y),
                     std::min(placement.origin.x + placement.size.x, other.origin.x + other.size.x),
                     std::min(placement.origin.y + placement.size.y, other.origin.y + other.size.y)});
  }
  return found;
}

/// Whether the centre of the base lies inside the convex hull of the contacts, not on its border: of every line
/// through two corners that has all corners on one side, the centre must lie on that side too.
bool centreOverHull(const Placement& placement, const std::vector<Rectangle>& rectangles) {
  std::vector<std::array<std::int64_t, 2>> corners;  // doubled, as the centre may be at half a millimetre
  for (const Rectangle& r : rectangles) {
    for (const int x : {r.x0, r.x1}) {
      for (const int y : {r.y0, r.y1}) corners.push_back({2LL * x, 2LL * y});
    }
  }
  const std::array<std::int64_t, 2> centre{2LL * placement.origin.x + placement.size.x,
                                           2LL * placement.origin.y + placement.size.y};
  const auto side = [](const auto& a, const auto& b, const auto& p) {
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
  };
  for (const auto& a : corners) {
    for (const auto& b : corners) {
      if (a == b || side(a, b, centre) > 0) continue;
      const bool all_left =
          std::all_of(corners.begin(), corners.end(), [&](const auto& c) { return side(a, b, c) >= 0; });
      if (all_left) return false;
    }
  }
  return !corners.empty();
}

std::vector<std::string> supportFaults(const packing::PalletRules& rules,
                                       const std::vector<Placement>& placed, const Placement& placement) {
  const std::int64_t base = static_cast<std::int64_t>(placement.size.x) * placement.size.y;
  const std::int64_t supported = supportedArea(rules, placement, placed);
  const double needed = rules.min_support_ratio * (1.0 - kRounding);
  if (static_cast<double>(supported) < needed * static_cast<double>(base)) {
    return {"only " + std::to_string(supported) + " of " + std::to_string(base) +
            " mm^2 of its base at z = " + std::to_string(placement.origin.z) + " are supported, at least " +
            std::to_string(rules.min_support_ratio) + " of it needed"};
  }
  if (supported < base && !centreOverHull(placement, contacts(rules, placement, placed))) {
    return {"the centre of its base does not lie over the support"};
  }
  return {};
}

bool isPositive(const Vec3& size) { return size.x > 0 && size.y > 0 && size.z > 0; }

bool insidePallet(const packing::PalletRules& rules, const Placement& p) {
  const Vec3& pallet = rules.size;
  const int over = rules.overhang;
  return p.origin.x >= -over && p.origin.y >= -over && p.origin.z >= 0 && p.size.x <= pallet.x + 2 * over &&
         p.size.y <= pallet.y + 2 * over && p.size.z <= pallet.z &&
         p.origin.x <= pallet.x + over - p.size.x && p.origin.y <= pallet.y + over - p.size.y &&
         p.origin.z <= pallet.z - p.size.z;
}

}  // namespace

std::int64_t supportedArea(const packing::PalletRules& rules, const Placement& placement,
                           const std::vector<Placement>& below) {
  const std::vector<Rectangle> rectangles = contacts(rules, placement, below);
  std::set<int> xs;
  std::set<int> ys;
  for (const Rectangle& r : rectangles) {
    xs.insert({r.x0, r.x1});
    ys.insert({r.y0, r.y1});
  }
  std::int64_t area = 0;
  for (auto x = xs.begin(); x != xs.end() && std::next(x) != xs.end(); ++x) {
    for (auto y = ys.begin(); y != ys.end() && std::next(y) != ys.end(); ++y) {
      const bool covered = std::any_of(rectangles.begin(), rectangles.end(), [&](const Rectangle& r) {
        return r.x0 <= *x && *x < r.x1 && r.y0 <= *y && *y < r.y1;
      });
      if (covered) area += static_cast<std::int64_t>(*std::next(x) - *x) * (*std::next(y) - *y);
    }
  }
  return area;
}

std::vector<std::string> placementFaults(const packing::PalletRules& rules,
                                         const std::vector<Placement>& placed, const Placement& placement) {
  if (!isPositive(placement.size)) {
    return {"size " + text(placement.size) + " mm is not positive"};
  }
  if (!insidePallet(rules, placement)) {
    return {"origin " + text(placement.origin) + " with size " + text(placement.size) +
            " mm is not inside the pallet of " + text(rules.size) + " mm"};
  }
  std::vector<std::string> found;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Placement& other = placed[i];
    if (top(other) <= placement.origin.z || !footprintsMeet(placement, other, rules.gap)) continue;
    const std::string name = "placement " + std::to_string(i);
    if (!footprintsMeet(placement, other, 0)) {
      found.push_back("is nearer than the gap of " + std::to_string(rules.gap) + " mm to " + name);
    } else if (other.origin.z < top(placement)) {
      found.push_back("overlaps " + name);
    } else {
      found.push_back("cannot be lowered from above: " + name + " stands over it");
    }
  }
  const std::vector<std::string> support = supportFaults(rules, placed, placement);
  found.insert(found.end(), support.begin(), support.end());
  return found;
}

std::vector<Vec3> allowedSizes(const packing::ItemType& type) {
  const Vec3& s = type.size;
  const packing::Rotations& rotations = type.rotations;
  std::vector<Vec3> sizes;
  const auto add = [&](bool vertical, const Vec3& size) {
    if (!vertical) return;
    sizes.push_back(size);
    if (rotations.yaw) sizes.push_back({size.y, size.x, size.z});
  };
  add(rotations.vertical[2], {s.x, s.y, s.z});
  add(rotations.vertical[0], {s.z, s.y, s.x});
  add(rotations.vertical[1], {s.x, s.z, s.y});
  return sizes;
}

std::vector<std::string> placementFaults(const packing::Order& order,
                                         const std::vector<Placement>& placements) {
  std::vector<std::string> found;
  std::vector<Placement> placed;
  placed.reserve(placements.size());
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const Placement& placement = placements[i];
    const std::string name = "placement " + std::to_string(i) + ": ";
    if (placement.type < 0 || static_cast<std::size_t>(placement.type) >= order.types.size()) {
      found.push_back(name + "type " + std::to_string(placement.type) + " is not in the order");
    } else {
      const packing::ItemType& type = order.types[static_cast<std::size_t>(placement.type)];
      const std::vector<Vec3> sizes = allowedSizes(type);
      if (std::find(sizes.begin(), sizes.end(), placement.size) == sizes.end()) {
        found.push_back(name + "size " + text(placement.size) + " mm: type '" + type.name + "' of " +
                        text(type.size) + " mm may not stand so");
      }
    }
    for (const std::string& fault : placementFaults(order.rules, placed, placement)) {
      found.push_back(name + fault);
    }
    // One outside the pallet stands in nobody's way: it has had its fault, and its numbers may be absurd.
    placed.push_back(isPositive(placement.size) && insidePallet(order.rules, placement) ? placement
                                                                                        : Placement{});
  }
  if (found.empty()) found = loadFaults(order, placements);
  return found;
}

bool fitsSomewhere(const packing::PalletRules& rules, const std::vector<Placement>& placed,
                   const Vec3& size) {
  std::set<int> levels{0};
  for (const Placement& p : placed) levels.insert(top(p));
  for (const int z : levels) {
    if (z > rules.size.z - size.z) break;
    // A box that fits can be pushed towards the origin until a wall, a box it is lowered past, or the edge of
    // its support stops it. Boxes whose tops are below z matter to nothing here.
    std::set<int> xs{-rules.overhang, 0};
    std::set<int> ys{-rules.overhang, 0};
    std::vector<Placement> near;
    for (const Placement& p : placed) {
      if (top(p) < z) continue;
      const int gap = top(p) > z ? rules.gap : 0;
      xs.insert(top(p) > z ? p.origin.x + p.size.x + gap : p.origin.x);
      ys.insert(top(p) > z ? p.origin.y + p.size.y + gap : p.origin.y);
      near.push_back(p);
    }
    for (const int x : xs) {
      for (const int y : ys) {
        const Placement tried{0, {x, y, z}, size};
        const bool clear =
            insidePallet(rules, tried) && std::none_of(near.begin(), near.end(), [&](const Placement& p) {
              return top(p) > z && footprintsMeet(tried, p, rules.gap);
            });
        if (clear && placementFaults(rules, near, tried).empty()) return true;
      }
    }
  }
  return false;
}

}  // namespace mixed_palletizing::instances
