// Source: the difference process of Lai and Chan (1997): every space that meets the box leaves up to six pieces, one
// beyond each of its faces; pieces within another space are not maximal and go.
#include "empty_spaces.hpp"

#include <algorithm>
#include <tuple>

namespace mixed_palletizing::packing {

namespace {

bool overlap(const Space& a, const Space& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y &&
         a.min.z < b.max.z && b.min.z < a.max.z;
}

bool contains(const Space& a, const Space& b) {
  return a.min.x <= b.min.x && a.min.y <= b.min.y && a.min.z <= b.min.z && a.max.x >= b.max.x &&
         a.max.y >= b.max.y && a.max.z >= b.max.z;
}

void addPieces(const Space& space, const Space& box, std::vector<Space>& pieces) {
  for (int Vec3::*side : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    if (space.min.*side < box.min.*side) {
      pieces.push_back(space);
      pieces.back().max.*side = box.min.*side;
    }
    if (box.max.*side < space.max.*side) {
      pieces.push_back(space);
      pieces.back().min.*side = box.max.*side;
    }
  }
}

void sortSpaces(std::vector<Space>& spaces) {
  const auto key = [](const Space& s) {
    return std::make_tuple(s.min.z, s.min.y, s.min.x, s.max.x, s.max.y, s.max.z);
  };
  std::sort(spaces.begin(), spaces.end(), [&](const Space& a, const Space& b) { return key(a) < key(b); });
}

}  // namespace

void cutOut(std::vector<Space>& spaces, const Space& box, std::vector<Space>& removed) {
  const auto first_met =
      std::stable_partition(spaces.begin(), spaces.end(), [&](const Space& s) { return !overlap(s, box); });
  std::vector<Space> pieces;
  for (auto met = first_met; met != spaces.end(); ++met) addPieces(*met, box, pieces);
  removed.insert(removed.end(), first_met, spaces.end());
  spaces.erase(first_met, spaces.end());
  // Larger pieces first, so that a piece can lie only in one that is there already.
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Space& a, const Space& b) { return volume(a.size()) > volume(b.size()); });
  for (const Space& piece : pieces) {
    const bool inside =
        std::any_of(spaces.begin(), spaces.end(), [&](const Space& s) { return contains(s, piece); });
    if (!inside) spaces.push_back(piece);
  }
  sortSpaces(spaces);
}

void restore(std::vector<Space>& spaces, const std::vector<Space>& removed) {
  const auto is_piece = [&](const Space& s) {
    return std::any_of(removed.begin(), removed.end(), [&](const Space& r) { return contains(r, s); });
  };
  spaces.erase(std::remove_if(spaces.begin(), spaces.end(), is_piece), spaces.end());
  spaces.insert(spaces.end(), removed.begin(), removed.end());
  sortSpaces(spaces);
}

}  // namespace mixed_palletizing::packing
