#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

namespace {

std::string text(const Vec3& v) {
  return std::to_string(v.x) + " x " + std::to_string(v.y) + " x " + std::to_string(v.z) + " mm";
}

bool fits(const Vec3& size, const Vec3& room) {
  return size.x <= room.x && size.y <= room.y && size.z <= room.z;
}

void addTypeProblems(const ItemType& type, const std::string& what, const PalletRules& rules,
                     std::vector<std::string>& lines) {
  const Vec3 pallet = rules.room().size();
  if (type.size.x <= 0 || type.size.y <= 0 || type.size.z <= 0) {
    lines.push_back(what + ".size: " + text(type.size) + ": every side must be positive");
    return;
  }
  const std::vector<Vec3> sizes = orientations(type);
  if (sizes.empty()) lines.push_back(what + ".rotations: no side may stand vertical");
  if (!sizes.empty() &&
      std::none_of(sizes.begin(), sizes.end(), [&](const Vec3& size) { return fits(size, pallet); })) {
    lines.push_back(what + ".size: " + text(type.size) + ": larger than the pallet of " + text(pallet) +
                    " in every allowed rotation");
  }
  if (!std::isfinite(type.weight_kg) || type.weight_kg < 0.0) {
    lines.push_back(what + ".weight_kg: " + std::to_string(type.weight_kg) +
                    ": must be finite and not negative");
  }
  if (rules.max_weight_kg > 0.0 && type.weight_kg > rules.max_weight_kg) {
    lines.push_back(what + ".weight_kg: " + std::to_string(type.weight_kg) + ": the pallet may carry " +
                    std::to_string(rules.max_weight_kg));
  }
  if (!std::isfinite(type.max_load_kg) || type.max_load_kg < 0.0) {
    lines.push_back(what + ".max_load_kg: " + std::to_string(type.max_load_kg) +
                    ": must be finite and not negative");
  }
}

}  // namespace

std::vector<Vec3> orientations(const ItemType& type) {
  const Vec3& s = type.size;
  const bool yaw = type.rotations.yaw;
  std::vector<Vec3> sizes;
  const auto add = [&sizes](const Vec3& size) {
    if (std::find(sizes.begin(), sizes.end(), size) == sizes.end()) sizes.push_back(size);
  };
  const auto addStanding = [&](bool allowed, const Vec3& size) {
    if (!allowed) return;
    add(size);
    if (yaw) add({size.y, size.x, size.z});
  };
  addStanding(type.rotations.vertical[2], s);
  addStanding(type.rotations.vertical[1], {s.x, s.z, s.y});
  addStanding(type.rotations.vertical[0], {s.z, s.y, s.x});
  return sizes;
}

std::vector<std::string> problems(const PalletRules& rules) {
  std::vector<std::string> lines;
  const auto badLength = [](int length) { return length <= 0 || length > kMaxPalletLength; };
  if (badLength(rules.size.x) || badLength(rules.size.y) || badLength(rules.size.z)) {
    lines.push_back("rules.size: " + text(rules.size) + ": every side must lie in 1 .. " +
                    std::to_string(kMaxPalletLength) + " mm");
  }
  if (rules.gap < 0 || rules.gap > kMaxPalletLength) {
    lines.push_back("rules.gap: " + std::to_string(rules.gap) + " mm: must lie in 0 .. " +
                    std::to_string(kMaxPalletLength) + " mm");
  }
  if (!(rules.min_support_ratio > 0.0 && rules.min_support_ratio <= 1.0)) {
    lines.push_back("rules.min_support_ratio: " + std::to_string(rules.min_support_ratio) +
                    ": must lie in (0, 1]");
  }
  if (rules.overhang < 0 || rules.overhang > kMaxPalletLength) {
    lines.push_back("rules.overhang: " + std::to_string(rules.overhang) + " mm: must lie in 0 .. " +
                    std::to_string(kMaxPalletLength) + " mm");
  } else if (rules.overhang > 0 && rules.min_support_ratio == 1.0) {
    lines.push_back("rules.overhang: " + std::to_string(rules.overhang) +
                    " mm: contradicts min_support_ratio 1, by which no box may stick out");
  }
  if (!std::isfinite(rules.max_weight_kg) || rules.max_weight_kg < 0.0) {
    lines.push_back("rules.max_weight_kg: " + std::to_string(rules.max_weight_kg) +
                    ": must be finite and not negative");
  }
  return lines;
}

Space PalletRules::room() const {
  return {{-overhang, -overhang, 0}, {size.x + overhang, size.y + overhang, size.z}};
}

int Order::itemCount() const { return std::accumulate(counts.begin(), counts.end(), 0); }

std::int64_t Order::itemVolume() const {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < std::min(types.size(), counts.size()); ++i) {
    sum += counts[i] * volume(types[i].size);
  }
  return sum;
}

std::vector<std::string> problems(const Order& order) {
  std::vector<std::string> lines = problems(order.rules);
  if (order.types.size() != order.counts.size()) {
    lines.push_back("counts: " + std::to_string(order.counts.size()) + " counts for " +
                    std::to_string(order.types.size()) + " types");
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < order.types.size(); ++i) {
    const std::string what = "types[" + std::to_string(i) + "] '" + order.types[i].name + "'";
    addTypeProblems(order.types[i], what, order.rules, lines);
    if (!order.types[i].name.empty() && !names.insert(order.types[i].name).second) {
      lines.push_back(what + ".name: given twice");
    }
  }
  std::int64_t items = 0;
  for (std::size_t i = 0; i < order.counts.size(); ++i) {
    items += std::max(order.counts[i], 0);
    if (order.counts[i] < 0) {
      lines.push_back("counts[" + std::to_string(i) + "]: " + std::to_string(order.counts[i]) +
                      ": must not be negative");
    }
  }
  if (items == 0) lines.emplace_back("counts: the order has no items");
  if (items > kMaxItems) {
    lines.push_back("counts: " + std::to_string(items) + " items: at most " + std::to_string(kMaxItems));
  }
  return lines;
}

}  // namespace mixed_palletizing::packing
