// What a pallet allows, judged voxel by voxel on a small grid: slow, and written without the packing core.
#pragma once

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing::test {

/// The boxes on a pallet as voxels of 1 mm; full support.
class VoxelPallet {
 public:
  VoxelPallet(const PalletRules& rules, const std::vector<Placement>& placements) : rules_(rules) {
    const Vec3& s = rules.size;
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

  /// Everything above the cell from z upwards is empty, in the cell and within the gap around it.
  bool freeAbove(int x, int y, int z) const {
    const int g = rules_.gap;
    for (int v = std::max(0, y - g); v <= std::min(rules_.size.y - 1, y + g); ++v) {
      for (int u = std::max(0, x - g); u <= std::min(rules_.size.x - 1, x + g); ++u) {
        for (int w = z; w < rules_.size.z; ++w) {
          if (at(u, v, w) >= 0) return false;
        }
      }
    }
    return true;
  }

  bool supported(int x, int y, int z) const { return z == 0 || at(x, y, z - 1) >= 0; }

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
    return static_cast<std::size_t>((z * rules_.size.y + y) * rules_.size.x + x);
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

using Corners = std::tuple<int, int, int, int, int, int>;

inline Corners corners(const Space& s) { return {s.min.x, s.min.y, s.min.z, s.max.x, s.max.y, s.max.z}; }

/// All supported maximal spaces by their definition: a full rectangle of base cells that grows to no side.
inline std::set<Corners> bruteForceSpaces(const PalletRules& rules, const VoxelPallet& voxels) {
  std::set<Corners> spaces;
  for (int z = 0; z < rules.size.z; ++z) {
    const auto cells = voxels.baseCells(z);
    for (int x0 = 0; x0 < rules.size.x; ++x0) {
      for (int y0 = 0; y0 < rules.size.y; ++y0) {
        if (!allSet(cells, x0, y0, x0 + 1, y0 + 1)) continue;
        for (int x1 = x0 + 1; x1 <= rules.size.x && allSet(cells, x1 - 1, y0, x1, y0 + 1); ++x1) {
          for (int y1 = y0 + 1; y1 <= rules.size.y && allSet(cells, x0, y1 - 1, x1, y1); ++y1) {
            const bool grows = allSet(cells, x0 - 1, y0, x0, y1) || allSet(cells, x1, y0, x1 + 1, y1) ||
                               allSet(cells, x0, y0 - 1, x1, y0) || allSet(cells, x0, y1, x1, y1 + 1);
            if (!grows) spaces.insert({x0, y0, z, x1, y1, rules.size.z});
          }
        }
      }
    }
  }
  return spaces;
}

}  // namespace mixed_palletizing::packing::test
