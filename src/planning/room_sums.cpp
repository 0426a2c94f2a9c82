#include <algorithm>

#include <mixed_palletizing/planning/room_sums.hpp>

namespace mixed_palletizing::planning {

void RoomSums::clear(std::size_t types) {
  places.assign(types, 0);
  capacities.assign(types, 0);
  room = fillable = dead = largest_base = 0.0;
  spaces = 0;
}

void RoomSums::addSpace(const packing::Space& space, const int* row, const std::vector<double>& volumes,
                        const std::vector<int>& remaining) {
  const std::size_t types = volumes.size();
  for (std::size_t t = 0; t < types; ++t) {
    places[t] += row[t];
    capacities[t] += row[types + t];
  }
  double fill = 0.0;
  for (std::size_t t = 0; t < types; ++t) {
    fill = std::max(fill, std::min(row[types + t], remaining[t]) * volumes[t]);
  }
  const packing::Vec3 size = space.size();
  const double base = static_cast<double>(size.x) * size.y;
  largest_base = std::max(largest_base, base);
  room += base * size.z;
  fillable += fill;
  if (fill == 0.0) dead += base * size.z;
  ++spaces;
}

void RoomSums::add(const RoomSums& other) {
  for (std::size_t t = 0; t < places.size(); ++t) {
    places[t] += other.places[t];
    capacities[t] += other.capacities[t];
  }
  room += other.room;
  fillable += other.fillable;
  dead += other.dead;
  largest_base = std::max(largest_base, other.largest_base);
  spaces += other.spaces;
}

void RoomSums::subtract(const RoomSums& part) {
  for (std::size_t t = 0; t < places.size(); ++t) {
    places[t] -= part.places[t];
    capacities[t] -= part.capacities[t];
  }
  room -= part.room;
  fillable -= part.fillable;
  dead -= part.dead;
  spaces -= part.spaces;
}

}  // namespace mixed_palletizing::planning
