// The spaces of one level of a pallet as rectangles.
#pragma once

#include <vector>

#include <mixed_palletizing/packing/types.hpp>

#include "maximal_rectangles.hpp"

namespace mixed_palletizing::packing {

inline Rect footprintOf(const Placement& p) {
  return {p.origin.x, p.origin.y, p.origin.x + p.size.x, p.origin.y + p.size.y};
}

inline Rect widened(const Rect& rect, int by) {
  return {rect.x0 - by, rect.y0 - by, rect.x1 + by, rect.y1 + by};
}

/// Fills `rects` with the bases of the sorted spaces at height `z`; the index of the first of them.
std::size_t rectsOfLevel(const std::vector<Space>& spaces, int z, std::vector<Rect>& rects);

/// Sorted spaces seen as levels of equal base height.
class LevelSpaces {
 public:
  LevelSpaces(std::vector<Space>& spaces, int pallet_height) : spaces_(spaces), height_(pallet_height) {}

  /// Base heights of all spaces, ascending.
  std::vector<int> heights() const;

  /// Replaces the rectangles of level `z` by what `change(rects)` makes of them; keeps the order.
  template <typename Change>
  void edit(int z, const Change& change) {
    thread_local std::vector<Rect> rects;
    read(z, rects);
    change(rects);
    write(z, rects);
  }

 private:
  void read(int z, std::vector<Rect>& rects);
  void write(int z, std::vector<Rect>& rects);

  std::vector<Space>& spaces_;
  int height_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

/// All maximal rectangles of level `z` from the placed boxes alone: where a box may stand with full support,
/// or, with partial support, where nothing stands higher and at least something supports.
std::vector<Rect> supportedRects(const PalletRules& rules, const std::vector<Placement>& placements, int z);

/// Removes rectangles that lie over no top at height `z`, on the floor those beside the pallet.
void dropUnsupported(std::vector<Rect>& rects, const PalletRules& rules, int z,
                     const std::vector<Placement>& placements);

}  // namespace mixed_palletizing::packing
