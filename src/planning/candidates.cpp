#include "candidates.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::planning {

std::string availableProblem(const std::vector<int>& available, const std::vector<int>& remaining) {
  std::vector<int> counts(remaining.size(), 0);
  for (const int type : available) {
    if (type < 0 || static_cast<std::size_t>(type) >= remaining.size()) {
      return "available: type " + std::to_string(type) + " of " + std::to_string(remaining.size()) + " types";
    }
    ++counts[static_cast<std::size_t>(type)];
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > remaining[i]) {
      return "available: " + std::to_string(counts[i]) + " items of type " + std::to_string(i) + ", only " +
             std::to_string(remaining[i]) + " remain";
    }
  }
  return {};
}

std::string whyNowhere(const packing::PalletState& pallet, const packing::ItemType& type, int type_index) {
  if (!pallet.carriesWeightOf(type_index)) {
    return "the pallet would be heavier than " + std::to_string(pallet.rules().max_weight_kg) + " kg";
  }
  int height_left = 0;  // over the places with room for the footprint
  int lowest = 0;       // height the item needs there
  for (const packing::Vec3& size : packing::orientations(type)) {
    for (const packing::Space& space : pallet.spaces()) {
      const packing::Vec3 room = space.size();
      if (room.x < size.x || room.y < size.y || room.z <= height_left) continue;
      height_left = room.z;
      lowest = size.z;
    }
  }
  if (height_left == 0) return "no level, supported and free place is large enough for its footprint";
  if (height_left < lowest) {
    return "where its footprint has room, at most " + std::to_string(height_left) + " mm of height are left";
  }
  return "where it has room, it would be held too little, overload what is below, or the gripper would touch "
         "other boxes";
}

std::vector<int> restItems(std::vector<int> remaining, int type) {
  --remaining[static_cast<std::size_t>(type)];
  std::vector<int> items;
  for (std::size_t i = 0; i < remaining.size(); ++i) {
    items.insert(items.end(), static_cast<std::size_t>(remaining[i]), static_cast<int>(i));
  }
  return items;
}

Situation withExpected(const Situation& situation) {
  Situation expected{situation.pallet, situation.types, situation.available, situation.remaining};
  for (std::size_t t = 0; t < situation.forecast.size(); ++t) {
    expected.remaining[t] += static_cast<int>(std::lround(situation.forecast[t]));
  }
  return expected;
}

std::size_t firstOfType(const std::vector<int>& available, std::size_t i) {
  return static_cast<std::size_t>(std::find(available.begin(), available.end(), available[i]) -
                                  available.begin());
}

}  // namespace mixed_palletizing::planning
