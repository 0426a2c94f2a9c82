#include "pallet_stability.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace mixed_palletizing::planning {
namespace {

using packing::Placement;
using Point = std::array<std::int64_t, 2>;

/// Length [mm] that two intervals have in common.
std::int64_t common(int a, int a_length, int b, int b_length) {
  return std::max(0, std::min(a + a_length, b + b_length) - std::max(a, b));
}

double supportOf(const Placement& box, const std::vector<Placement>& placements) {
  if (box.origin.z == 0) return 1.0;
  std::int64_t area = 0;
  for (const Placement& below : placements) {
    if (below.origin.z + below.size.z != box.origin.z) continue;
    area += common(box.origin.x, box.size.x, below.origin.x, below.size.x) *
            common(box.origin.y, box.size.y, below.origin.y, below.size.y);
  }
  return static_cast<double>(area) / (static_cast<double>(box.size.x) * box.size.y);
}

std::int64_t cross(const Point& o, const Point& a, const Point& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/// Convex hull, counterclockwise (Andrew 1979).
std::vector<Point> hullOf(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Point> hull;
  const auto addChain = [&hull](auto begin, auto end) {
    const std::size_t kept = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= kept + 2 && cross(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // it begins the other chain
  };
  addChain(points.begin(), points.end());
  addChain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace

std::array<double, 3> centreOfGravity(const packing::PalletState& pallet, const packing::Order& order) {
  const auto typeOf = [&order](const Placement& p) -> const packing::ItemType& {
    return order.types[static_cast<std::size_t>(p.type)];
  };
  const auto& placements = pallet.placements();
  const bool weights_known = std::all_of(placements.begin(), placements.end(),
                                         [&](const auto& p) { return typeOf(p).weight_kg > 0.0; });
  std::array<double, 3> centre{};
  double total = 0.0;
  for (const Placement& p : placements) {
    const double weight = weights_known ? typeOf(p).weight_kg : static_cast<double>(packing::volume(p.size));
    centre[0] += weight * (p.origin.x + 0.5 * p.size.x);
    centre[1] += weight * (p.origin.y + 0.5 * p.size.y);
    centre[2] += weight * (p.origin.z + 0.5 * p.size.z);
    total += weight;
  }
  for (double& coordinate : centre) coordinate = total > 0.0 ? coordinate / total : 0.0;
  return centre;
}

double leastSupport(const packing::PalletState& pallet) {
  double least = 1.0;
  for (const Placement& p : pallet.placements()) least = std::min(least, supportOf(p, pallet.placements()));
  return least;
}

double gravityMargin(const packing::PalletState& pallet, const std::array<double, 3>& centre) {
  std::vector<Point> corners;
  for (const Placement& p : pallet.placements()) {
    if (p.origin.z != 0) continue;
    for (const std::int64_t x : {p.origin.x, p.origin.x + p.size.x}) {
      for (const std::int64_t y : {p.origin.y, p.origin.y + p.size.y}) corners.push_back({x, y});
    }
  }
  if (corners.empty()) return 0.0;
  const std::vector<Point> hull = hullOf(corners);
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point& a = hull[i];
    const Point& b = hull[(i + 1) % hull.size()];
    const double dx = static_cast<double>(b[0] - a[0]);
    const double dy = static_cast<double>(b[1] - a[1]);
    const double area =
        dx * (centre[1] - static_cast<double>(a[1])) - dy * (centre[0] - static_cast<double>(a[0]));
    margin = std::min(margin, area / std::hypot(dx, dy));
  }
  return margin;
}

}  // namespace mixed_palletizing::planning
