// What a pallet allows, judged voxel by voxel on a small grid: slow, and written without the packing core.
#pragma once

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing::test {

using Point = std::pair<int, int>;

/// Strictly inside the convex hull, by Andrew's monotone chain.
inline bool strictlyInHull(const Point& p, std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return false;
  const auto cross = [](const Point& o, const Point& a, const Point& b) {
    return (a.first - o.first) * (b.second - o.second) - (a.second - o.second) * (b.first - o.first);
  };
  std::vector<Point> hull;
  const auto addChain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto q = begin; q != end; ++q) {
      while (hull.size() >= first + 2 && cross(hull[hull.size() - 2], hull.back(), *q) <= 0) hull.pop_back();
      hull.push_back(*q);
    }
    hull.pop_back();
  };
  addChain(points.begin(), points.end());
  addChain(points.rbegin(), points.rend());
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (cross(hull[i], hull[(i + 1) % hull.size()], p) <= 0) return false;
  }
  return true;
}

/// The boxes on a pallet as voxels of 1 mm.
class VoxelPallet {
 public:
  VoxelPallet(const PalletRules& rules, const std::vector<Placement>& placements) : rules_(rules) {
    const Vec3 s = rules.room().size();
    voxels_.assign(static_cast<std::size_t>(s.x * s.y * s.z), -1);
    for (std::size_t i = 0; i < placements.size(); ++i) {
      const Placement& p = placements[i];
      for (int z = p.origin.z; z < p.origin.z + p.size.z; ++z) {
        for (int y = p.origin.y; y < p.origin.y + p.size.y; ++y) {
          for (int x = p.origin.x; x < p.origin.x + p.size.x; ++x) {
            if (at(x, y, z) >= 0) overlap_ = true;
            voxels_[index(x, y, z)] = static_cast<int>(i);
          }
        }
      }
    }
  }

  bool overlap() const { return overlap_; }
  bool empty(int x, int y, int z) const { return at(x, y, z) < 0; }

  /// Everything from z upwards is empty, in the cell and within the gap around it.
  bool freeAbove(int x, int y, int z) const {
    const int g = rules_.gap;
    const Space room = rules_.room();
    for (int v = std::max(room.min.y, y - g); v <= std::min(room.max.y - 1, y + g); ++v) {
      for (int u = std::max(room.min.x, x - g); u <= std::min(room.max.x - 1, x + g); ++u) {
        for (int w = z; w < rules_.size.z; ++w) {
          if (at(u, v, w) >= 0) return false;
        }
      }
    }
    return true;
  }

  /// Something ends exactly below the cell.
  bool supported(int x, int y, int z) const {
    if (z == 0) return x >= 0 && y >= 0 && x < rules_.size.x && y < rules_.size.y;
    return (at(x, y, z - 1) >= 0 && (z == rules_.size.z || at(x, y, z) != at(x, y, z - 1)));
  }

  /// The rules of a placement by counting voxels.
  bool accepts(const Placement& p) const {
    const Space room = rules_.room();
    if (p.origin.x < room.min.x || p.origin.y < room.min.y || p.origin.z < 0 ||
        p.origin.x + p.size.x > room.max.x || p.origin.y + p.size.y > room.max.y ||
        p.origin.z + p.size.z > room.max.z) {
      return false;
    }
    int carried = 0;
    std::vector<std::pair<int, int>> contact;
    for (int x = p.origin.x; x < p.origin.x + p.size.x; ++x) {
      for (int y = p.origin.y; y < p.origin.y + p.size.y; ++y) {
        if (!freeAbove(x, y, p.origin.z)) return false;
        if (!supported(x, y, p.origin.z)) continue;
        ++carried;
        for (const int u : {x, x + 1}) {
          for (const int v : {y, y + 1}) contact.emplace_back(2 * u, 2 * v);
        }
      }
    }
    const int base = p.size.x * p.size.y;
    if (carried < rules_.min_support_ratio * base) return false;
    return carried == base || strictlyInHull({2 * p.origin.x + p.size.x, 2 * p.origin.y + p.size.y}, contact);
  }

  /// Cells [x][y] in which a base at height z may lie.
  std::vector<std::vector<char>> baseCells(int z) const {
    std::vector<std::vector<char>> cells(static_cast<std::size_t>(rules_.size.x),
                                         std::vector<char>(static_cast<std::size_t>(rules_.size.y)));
    for (int x = 0; x < rules_.size.x; ++x) {
      for (int y = 0; y < rules_.size.y; ++y) {
        cells[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)] =
            supported(x, y, z) && freeAbove(x, y, z);
      }
    }
    return cells;
  }

 private:
  std::size_t index(int x, int y, int z) const {
    const Vec3 s = rules_.room().size();
    return static_cast<std::size_t>((z * s.y + y + rules_.overhang) * s.x + x + rules_.overhang);
  }
  int at(int x, int y, int z) const { return voxels_[index(x, y, z)]; }

  PalletRules rules_;
  std::vector<int> voxels_;
  bool overlap_ = false;
};

inline bool allSet(const std::vector<std::vector<char>>& cells, int x0, int y0, int x1, int y1) {
  if (x0 < 0 || y0 < 0 || x1 > static_cast<int>(cells.size()) || y1 > static_cast<int>(cells[0].size())) {
    return false;
  }
  for (int x = x0; x < x1; ++x) {
    for (int y = y0; y < y1; ++y) {
      if (!cells[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)]) return false;
    }
  }
  return true;
}

/// All maximal empty cuboids, by their definition.
inline std::set<std::tuple<int, int, int, int, int, int>> bruteForceEmptySpaces(const PalletRules& rules,
                                                                                const VoxelPallet& voxels) {
  std::set<std::tuple<int, int, int, int, int, int>> spaces;
  const Vec3& s = rules.size;
  const auto empty = [&](int x0, int y0, int z0, int x1, int y1, int z1) {
    if (x0 < 0 || y0 < 0 || z0 < 0 || x1 > s.x || y1 > s.y || z1 > s.z) return false;
    for (int z = z0; z < z1; ++z) {
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
          if (!voxels.empty(x, y, z)) return false;
        }
      }
    }
    return true;
  };
  for (int z0 = 0; z0 < s.z; ++z0)
    for (int y0 = 0; y0 < s.y; ++y0)
      for (int x0 = 0; x0 < s.x; ++x0)
        for (int x1 = x0 + 1; x1 <= s.x && empty(x0, y0, z0, x1, y0 + 1, z0 + 1); ++x1)
          for (int y1 = y0 + 1; y1 <= s.y && empty(x0, y1 - 1, z0, x1, y1, z0 + 1); ++y1)
            for (int z1 = z0 + 1; z1 <= s.z && empty(x0, y0, z1 - 1, x1, y1, z1); ++z1) {
              const bool grows = empty(x0 - 1, y0, z0, x0, y1, z1) || empty(x1, y0, z0, x1 + 1, y1, z1) ||
                                 empty(x0, y0 - 1, z0, x1, y0, z1) || empty(x0, y1, z0, x1, y1 + 1, z1) ||
                                 empty(x0, y0, z0 - 1, x1, y1, z0) || empty(x0, y0, z1, x1, y1, z1 + 1);
              if (!grows) spaces.insert({x0, y0, z0, x1, y1, z1});
            }
  return spaces;
}

/// A full rectangle of cells that can grow to no side.
inline bool isMaximal(const std::vector<std::vector<char>>& cells, int x0, int y0, int x1, int y1) {
  return allSet(cells, x0, y0, x1, y1) && !allSet(cells, x0 - 1, y0, x0, y1) &&
         !allSet(cells, x1, y0, x1 + 1, y1) && !allSet(cells, x0, y0 - 1, x1, y0) &&
         !allSet(cells, x0, y1, x1, y1 + 1);
}

using Corners = std::tuple<int, int, int, int, int, int>;

inline Corners corners(const Space& s) { return {s.min.x, s.min.y, s.min.z, s.max.x, s.max.y, s.max.z}; }

/// All supported maximal spaces of full support, by their definition.
inline std::set<Corners> bruteForceSpaces(const PalletRules& rules, const VoxelPallet& voxels) {
  std::set<Corners> spaces;
  for (int z = 0; z < rules.size.z; ++z) {
    const auto cells = voxels.baseCells(z);
    for (int x0 = 0; x0 < rules.size.x; ++x0) {
      for (int y0 = 0; y0 < rules.size.y; ++y0) {
        if (!allSet(cells, x0, y0, x0 + 1, y0 + 1)) continue;
        for (int x1 = x0 + 1; x1 <= rules.size.x && allSet(cells, x1 - 1, y0, x1, y0 + 1); ++x1) {
          for (int y1 = y0 + 1; y1 <= rules.size.y && allSet(cells, x0, y1 - 1, x1, y1); ++y1) {
            if (isMaximal(cells, x0, y0, x1, y1)) spaces.insert({x0, y0, z, x1, y1, rules.size.z});
          }
        }
      }
    }
  }
  return spaces;
}

}  // namespace mixed_palletizing::packing::test
