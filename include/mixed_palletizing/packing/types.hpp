// Items, orders and placements. Lengths are integer millimetres, so contact and equality are exact.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mixed_palletizing::packing {

/// A length triple [mm]: a size, or a point in the pallet frame (corner of the pallet, z up).
struct Vec3 {
  int x = 0;
  int y = 0;
  int z = 0;

  friend bool operator==(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
  friend bool operator!=(const Vec3& a, const Vec3& b) { return !(a == b); }
};

/// Volume [mm^3] of a size.
inline std::int64_t volume(const Vec3& size) { return static_cast<std::int64_t>(size.x) * size.y * size.z; }

/// Which of an item's sides may stand vertical, and whether it may turn about the vertical.
struct Rotations {
  bool yaw = false;                                  ///< may be turned by 90 degrees about the vertical
  std::array<bool, 3> vertical{false, false, true};  ///< x, y, z side may stand vertical

  static Rotations none() { return {}; }
  static Rotations yawOnly() { return {true, {false, false, true}}; }
  static Rotations any() { return {true, {true, true, true}}; }
};

/// One type of item of an order.
struct ItemType {
  std::string name;
  Vec3 size;  ///< as given by the order [mm]
  Rotations rotations;
  double weight_kg = 0.0;    ///< 0 = not known
  double max_load_kg = 0.0;  ///< on its top (LoadBook says how it is counted); 0 = no limit
};

/// The distinct sizes in which a type may be placed, the given orientation first when it is allowed. Without
/// yaw, an item is laid down about its y side (x side vertical) or its x side (y side vertical).
std::vector<Vec3> orientations(const ItemType& type);

constexpr int kMaxPalletLength = 20000;  ///< [mm] longest side of a packing volume: a container's
constexpr int kMaxItems = 100000;        ///< in one order

/// Cuboid of free room [min, max) in the pallet frame [mm].
struct Space {
  Vec3 min;
  Vec3 max;

  Vec3 size() const { return {max.x - min.x, max.y - min.y, max.z - min.z}; }
  friend bool operator==(const Space& a, const Space& b) { return a.min == b.min && a.max == b.max; }
};

/// Rules of a pallet.
struct PalletRules {
  Vec3 size;  ///< packing volume [mm]

  /// Free space kept beside every box [mm], in x or in y, towards every other box that it stands beside or
  /// is lowered past; none towards the pallet's border.
  int gap = 0;

  /// Share of a box's base area on the floor or on tops at exactly its base height, (0, 1]. The area over a
  /// gap is not supported: with a gap, boxes that bridge two others need a ratio below 1. Below 1 the centre
  /// of the base must lie over the support, inside the convex hull of the contact area.
  double min_support_ratio = 1.0;

  /// How far boxes may stick out beyond the pallet's four sides [mm]. Only the pallet supports what stands at
  /// its height, so an overhang needs a support ratio below 1.
  int overhang = 0;

  double max_weight_kg = 0.0;  ///< of all boxes together; 0 = no limit

  /// The packing volume with the overhang.
  Space room() const;
};

/// Every broken rule as one line; empty when a pallet can be made by them.
std::vector<std::string> problems(const PalletRules& rules);

/// A set of items for one pallet: `counts[i]` items of `types[i]`.
struct Order {
  PalletRules rules;
  std::vector<ItemType> types;
  std::vector<int> counts;

  int itemCount() const;
  std::int64_t itemVolume() const;  ///< [mm^3]
};

/// Every broken rule as one line "what: value: why"; empty when the order can be packed with.
std::vector<std::string> problems(const Order& order);

/// An item at its place: the corner nearest the pallet's origin and the size as placed [mm].
struct Placement {
  int type = 0;  ///< index in Order::types
  Vec3 origin;
  Vec3 size;

  friend bool operator==(const Placement& a, const Placement& b) {
    return a.type == b.type && a.origin == b.origin && a.size == b.size;
  }
};

}  // namespace mixed_palletizing::packing
