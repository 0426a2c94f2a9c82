// The maximal rectangles of a region in the plane, kept up to date while rectangles are cut out and added.
#pragma once

#include <algorithm>
#include <vector>

namespace mixed_palletizing::packing {

/// [x0, x1) x [y0, y1) [mm].
struct Rect {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  bool empty() const { return x0 >= x1 || y0 >= y1; }
  bool contains(const Rect& r) const { return x0 <= r.x0 && y0 <= r.y0 && x1 >= r.x1 && y1 >= r.y1; }
  bool overlaps(const Rect& r) const { return x0 < r.x1 && r.x0 < x1 && y0 < r.y1 && r.y0 < y1; }
  friend bool operator==(const Rect& a, const Rect& b) {
    return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1;
  }
};

inline Rect intersection(const Rect& a, const Rect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

/// `rects` are all maximal rectangles of a region; afterwards they are those of the region without `hole`.
void cutOut(std::vector<Rect>& rects, const Rect& hole);

/// `rects` are all maximal rectangles of a region; afterwards they are those of its union with `part`.
void addRect(std::vector<Rect>& rects, const Rect& part);

}  // namespace mixed_palletizing::packing
