#include "level_spaces.hpp"

#include <algorithm>
#include <tuple>

namespace mixed_palletizing::packing {

std::size_t rectsOfLevel(const std::vector<Space>& spaces, int z, std::vector<Rect>& rects) {
  const auto below = [](const Space& space, int height) { return space.min.z < height; };
  auto space = std::lower_bound(spaces.begin(), spaces.end(), z, below);
  const auto begin = static_cast<std::size_t>(space - spaces.begin());
  rects.clear();
  for (; space != spaces.end() && space->min.z == z; ++space) {
    rects.push_back({space->min.x, space->min.y, space->max.x, space->max.y});
  }
  return begin;
}

std::vector<int> LevelSpaces::heights() const {
  std::vector<int> heights;
  for (const Space& space : spaces_) {
    if (heights.empty() || heights.back() != space.min.z) heights.push_back(space.min.z);
  }
  return heights;
}

void LevelSpaces::read(int z, std::vector<Rect>& rects) {
  begin_ = rectsOfLevel(spaces_, z, rects);
  end_ = begin_ + rects.size();
}

void LevelSpaces::write(int z, std::vector<Rect>& rects) {
  std::sort(rects.begin(), rects.end(), [](const Rect& a, const Rect& b) {
    return std::tie(a.y0, a.x0, a.x1, a.y1) < std::tie(b.y0, b.x0, b.x1, b.y1);
  });
  const auto at = [this](std::size_t i) { return spaces_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t end = begin_ + rects.size();
  if (end > end_) spaces_.insert(at(end_), end - end_, Space{});
  if (end < end_) spaces_.erase(at(end), at(end_));
  for (std::size_t i = 0; i < rects.size(); ++i) {
    const Rect& r = rects[i];
    spaces_[begin_ + i] = {{r.x0, r.y0, z}, {r.x1, r.y1, height_}};
  }
  end_ = end;
}

std::vector<Rect> supportedRects(const PalletRules& rules, const std::vector<Placement>& placements, int z) {
  const bool full_support = rules.min_support_ratio == 1.0;
  std::vector<Rect> rects;
  const Space room = rules.room();
  if (z == 0 || !full_support) rects.push_back({room.min.x, room.min.y, room.max.x, room.max.y});
  for (const Placement& p : placements) {
    if (full_support && p.origin.z + p.size.z == z) addRect(rects, footprintOf(p));
  }
  for (const Placement& p : placements) {
    if (p.origin.z + p.size.z > z) cutOut(rects, widened(footprintOf(p), rules.gap));
  }
  dropUnsupported(rects, rules, z, placements);
  return rects;
}

void dropUnsupported(std::vector<Rect>& rects, const PalletRules& rules, int z,
                     const std::vector<Placement>& placements) {
  if (z == 0 && rules.overhang == 0) return;
  const auto unsupported = [&](const Rect& rect) {
    if (z == 0) return !rect.overlaps({0, 0, rules.size.x, rules.size.y});
    return std::none_of(placements.begin(), placements.end(), [&](const Placement& p) {
      return p.origin.z + p.size.z == z && footprintOf(p).overlaps(rect);
    });
  };
  rects.erase(std::remove_if(rects.begin(), rects.end(), unsupported), rects.end());
}

}  // namespace mixed_palletizing::packing
