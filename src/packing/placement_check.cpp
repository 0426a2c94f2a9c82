#include "placement_check.hpp"

#include <cstddef>
#include <cstdint>

#include "level_spaces.hpp"
#include "maximal_rectangles.hpp"

namespace mixed_palletizing::packing {

namespace {

/// Exact products of integers stay exact in the comparison up to this relative rounding.
constexpr double kRatioTolerance = 1e-12;

std::string text(const Vec3& v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ") mm";
}

bool inside(int origin, int length, int low, int high) {
  return origin >= low && origin <= high && length <= high - origin;
}

std::string brokenBounds(const PalletRules& rules, const Placement& p) {
  if (p.type < 0) return "type " + std::to_string(p.type) + " is negative";
  if (p.size.x <= 0 || p.size.y <= 0 || p.size.z <= 0) return "size " + text(p.size) + " is not positive";
  const Space room = rules.room();
  if (!inside(p.origin.x, p.size.x, room.min.x, room.max.x) ||
      !inside(p.origin.y, p.size.y, room.min.y, room.max.y) ||
      !inside(p.origin.z, p.size.z, room.min.z, room.max.z)) {
    return "box at " + text(p.origin) + " of " + text(p.size) + " sticks out of the pallet of " +
           text(rules.size) +
           (rules.overhang > 0 ? " by more than " + std::to_string(rules.overhang) + " mm" : std::string());
  }
  return {};
}

/// Every box that rises above the new base must keep clear of the shaft the new box is lowered through.
std::string brokenClearance(const PalletRules& rules, const std::vector<Placement>& placed,
                            const Placement& p) {
  const Rect footprint = footprintOf(p);
  const Rect shaft = widened(footprint, rules.gap);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Placement& other = placed[i];
    if (other.origin.z + other.size.z <= p.origin.z || !footprintOf(other).overlaps(shaft)) continue;
    const std::string name = "box " + std::to_string(i) + " at " + text(other.origin);
    if (!footprintOf(other).overlaps(footprint)) {
      return "closer than the gap of " + std::to_string(rules.gap) + " mm to " + name;
    }
    if (other.origin.z < p.origin.z + p.size.z) return "overlaps " + name;
    return "cannot be lowered: below " + name;
  }
  return {};
}

struct Point {
  std::int64_t x;
  std::int64_t y;
};

/// Strictly inside the convex hull: no line through `center` leaves all points on one side.
bool insideHull(const Point& center, const std::vector<Point>& points) {
  for (const Point& p : points) {
    if (p.x == center.x && p.y == center.y) continue;
    bool left = false;
    bool right = false;
    for (const Point& q : points) {
      const std::int64_t cross = (p.x - center.x) * (q.y - center.y) - (p.y - center.y) * (q.x - center.x);
      left = left || cross > 0;
      right = right || cross < 0;
    }
    if (!left || !right) return false;
  }
  return !points.empty();
}

struct Support {
  std::int64_t area = 0;  ///< of the base [mm^2]
  std::int64_t supported = 0;
  bool center_over = true;  ///< the centre of the base lies over the support

  double ratio() const { return static_cast<double>(supported) / static_cast<double>(area); }
  bool reaches(double least) const { return ratio() >= least * (1.0 - kRatioTolerance); }
};

Support supportOf(const PalletRules& rules, const std::vector<Placement>& placed, const Placement& p) {
  const Rect footprint = footprintOf(p);
  const Rect deck{0, 0, rules.size.x, rules.size.y};
  Support support;
  support.area = static_cast<std::int64_t>(p.size.x) * p.size.y;
  support.supported = support.area;
  if (p.origin.z == 0 && deck.contains(footprint)) return support;
  support.supported = 0;
  std::vector<Point> contact;  // twice the coordinates, so that the centre of the base is exact
  const auto rest = [&](const Rect& top) {
    const Rect r = intersection(footprint, top);
    if (r.empty()) return;
    support.supported += static_cast<std::int64_t>(r.x1 - r.x0) * (r.y1 - r.y0);
    for (const int x : {r.x0, r.x1}) {
      for (const int y : {r.y0, r.y1}) contact.push_back({2LL * x, 2LL * y});
    }
  };
  if (p.origin.z == 0) rest(deck);
  for (const Placement& other : placed) {
    if (p.origin.z > 0 && other.origin.z + other.size.z == p.origin.z) rest(footprintOf(other));
  }
  const Point center{2LL * p.origin.x + p.size.x, 2LL * p.origin.y + p.size.y};
  support.center_over = support.supported == support.area || insideHull(center, contact);
  return support;
}

std::string brokenSupport(const PalletRules& rules, const std::vector<Placement>& placed,
                          const Placement& p) {
  const Support support = supportOf(rules, placed, p);
  if (!support.reaches(rules.min_support_ratio)) {
    return "supported share of the base at " + text(p.origin) + " is " + std::to_string(support.ratio()) +
           ", less than " + std::to_string(rules.min_support_ratio);
  }
  if (!support.center_over) return "centre of the base at " + text(p.origin) + " is not over its support";
  return {};
}

}  // namespace

std::string brokenRule(const PalletRules& rules, const std::vector<Placement>& placed,
                       const Placement& placement) {
  std::string broken = brokenBounds(rules, placement);
  if (broken.empty()) broken = brokenClearance(rules, placed, placement);
  if (broken.empty()) broken = brokenSupport(rules, placed, placement);
  return broken;
}

bool keepsRules(const PalletRules& rules, const std::vector<Placement>& placed, const Placement& placement) {
  if (!brokenBounds(rules, placement).empty()) return false;
  const Rect shaft = widened(footprintOf(placement), rules.gap);
  for (const Placement& other : placed) {
    if (other.origin.z + other.size.z > placement.origin.z && footprintOf(other).overlaps(shaft))
      return false;
  }
  return isSupported(rules, placed, placement);
}

bool isSupported(const PalletRules& rules, const std::vector<Placement>& placed, const Placement& placement) {
  const Support support = supportOf(rules, placed, placement);
  return support.reaches(rules.min_support_ratio) && support.center_over;
}

}  // namespace mixed_palletizing::packing
