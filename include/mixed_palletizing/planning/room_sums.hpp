// What the free spaces of a pallet come to, in sums that can be taken apart again.
#pragma once

#include <cstddef>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::planning {

/// Over some spaces; spaces that overlap are counted each.
struct RoomSums {
  std::vector<int> places;      ///< per type: items side by side on the bases
  std::vector<int> capacities;  ///< per type: items stacked up to the height limit
  double room = 0.0;            ///< [mm^3]
  double fillable = 0.0;        ///< by items of the one type that fills most, as far as they remain [mm^3]
  double dead = 0.0;            ///< room of the spaces that hold nothing of what remains [mm^3]
  double largest_base = 0.0;    ///< [mm^2]
  int spaces = 0;

  /// Of no spaces.
  void clear(std::size_t types);

  /// Adds a space. `row`: its places, then its capacities, per type; `volumes`: of an item per type [mm^3].
  void addSpace(const packing::Space& space, const int* row, const std::vector<double>& volumes,
                const std::vector<int>& remaining);

  void add(const RoomSums& other);

  /// Takes spaces away that were added before; largest_base stays. Exact: all numbers are whole.
  void subtract(const RoomSums& part);
};

}  // namespace mixed_palletizing::planning
