// Source: the split of empty maximal spaces (Lai and Chan 1997) and the merge of supported ones
// (thesis 3.3.1), both in the plane of one level.
//   cutOut:  every rectangle that meets the hole leaves up to four pieces (left, right, front, back); pieces
//            that lie within another rectangle are not maximal and go.
//   addRect: closure under consensus. Two rectangles that touch or overlap in x share the strip of
//            their common y range over both x ranges (and with x and y exchanged). A set closed under both, with contained
//            rectangles removed, holds every maximal rectangle of its union: otherwise take the smallest
//            rectangle of the union that lies in none; halved along a line between two of the set's
//            coordinates both halves lie in some rectangle, and the consensus of those two contains the
//            whole.
#include "maximal_rectangles.hpp"

#include <cstddef>

namespace mixed_palletizing::packing {

namespace {

bool insideAny(const std::vector<Rect>& rects, const Rect& rect) {
  return std::any_of(rects.begin(), rects.end(), [&](const Rect& r) { return r.contains(rect); });
}

/// Adds `rect` unless it lies in another; removes those that lie in it. Order is not kept.
bool absorb(std::vector<Rect>& rects, const Rect& rect) {
  if (insideAny(rects, rect)) return false;
  for (std::size_t i = rects.size(); i-- > 0;) {
    if (!rect.contains(rects[i])) continue;
    rects[i] = rects.back();
    rects.pop_back();
  }
  rects.push_back(rect);
  return true;
}

Rect consensusX(const Rect& a, const Rect& b) {
  if (std::max(a.x0, b.x0) > std::min(a.x1, b.x1)) return {};
  return {std::min(a.x0, b.x0), std::max(a.y0, b.y0), std::max(a.x1, b.x1), std::min(a.y1, b.y1)};
}

Rect consensusY(const Rect& a, const Rect& b) {
  if (std::max(a.y0, b.y0) > std::min(a.y1, b.y1)) return {};
  return {std::max(a.x0, b.x0), std::min(a.y0, b.y0), std::min(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace

void cutOut(std::vector<Rect>& rects, const Rect& hole) {
  thread_local std::vector<Rect> pieces;
  if (hole.empty()) return;
  pieces.clear();
  for (std::size_t i = rects.size(); i-- > 0;) {
    const Rect r = rects[i];
    if (!r.overlaps(hole)) continue;
    rects[i] = rects.back();
    rects.pop_back();
    if (r.x0 < hole.x0) pieces.push_back({r.x0, r.y0, hole.x0, r.y1});
    if (hole.x1 < r.x1) pieces.push_back({hole.x1, r.y0, r.x1, r.y1});
    if (r.y0 < hole.y0) pieces.push_back({r.x0, r.y0, r.x1, hole.y0});
    if (hole.y1 < r.y1) pieces.push_back({r.x0, hole.y1, r.x1, r.y1});
  }
  for (const Rect& piece : pieces) absorb(rects, piece);
}

void addRect(std::vector<Rect>& rects, const Rect& part) {
  thread_local std::vector<Rect> queue;
  thread_local std::vector<Rect> others;
  if (part.empty() || !absorb(rects, part)) return;
  queue.assign(1, part);
  while (!queue.empty()) {
    const Rect rect = queue.back();
    queue.pop_back();
    others = rects;
    for (const Rect& other : others) {
      for (const Rect& merged : {consensusX(rect, other), consensusY(rect, other)}) {
        if (!merged.empty() && absorb(rects, merged)) queue.push_back(merged);
      }
    }
  }
}

}  // namespace mixed_palletizing::packing
