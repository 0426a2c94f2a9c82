// Random orders with a known perfect packing (thesis 4.2.1).
//
// 1. The footprint of the pallet is halved along its longer side again and again; every part of it whose
//    share is among the divisors may become the footprint of boxes.
// 2. Columns: a part either becomes a column of boxes of its footprint or is halved once more; a column is
//    filled to the top by heights of the list.
//    Blocks: a part of the volume may also be cut horizontally, so that a large box stands across smaller
//    ones.
//    Cuts: the whole volume is cut across again and again, at any millimetre.
// 3. The boxes of the packing are the order; they arrive shuffled. With a spread of sizes the types become a
//    little larger or smaller then.
#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>
#include <tuple>

#include <mixed_palletizing/instances/files.hpp>
#include <mixed_palletizing/instances/generator.hpp>

#include "guillotine.hpp"

namespace mixed_palletizing::instances {
namespace {

constexpr int kMaxDivisor = 1 << 20;
constexpr int kMaxCutBoxes = 10000;

bool isPowerOfTwo(int value) { return value > 0 && (value & (value - 1)) == 0; }

std::string sizeName(const packing::Vec3& size) {
  return std::to_string(size.x) + "x" + std::to_string(size.y) + "x" + std::to_string(size.z);
}

packing::PalletRules rulesOf(const GeneratorOptions& options) {
  packing::PalletRules rules;
  rules.size = options.pallet;
  rules.gap = options.gap;
  rules.min_support_ratio = options.min_support_ratio;
  return rules;
}

void checkFootprints(const GeneratorOptions& options, std::vector<std::string>& found) {
  if (options.footprint_divisors.empty()) found.emplace_back("footprint_divisors: none given");
  for (const int divisor : options.footprint_divisors) {
    if (!isPowerOfTwo(divisor) || divisor > kMaxDivisor) {
      found.push_back("footprint_divisors: " + std::to_string(divisor) + ": must be a power of two up to " +
                      std::to_string(kMaxDivisor));
      continue;
    }
    try {
      footprint(options.pallet, divisor);
    } catch (const std::invalid_argument& error) {
      found.push_back("footprint_divisors: " + std::to_string(divisor) + ": " + error.what());
    }
  }
}

void checkHeights(const GeneratorOptions& options, std::vector<std::string>& found) {
  if (options.heights.empty()) found.emplace_back("heights: none given");
  for (const int height : options.heights) {
    if (height < 1) found.push_back("heights: " + std::to_string(height) + " mm: must be positive");
  }
  if (!found.empty()) return;
  if (!reachableHeights(heightsOf(options), options.pallet.z).back()) {
    found.push_back("heights: no sum of them is the pallet's height of " + std::to_string(options.pallet.z) +
                    " mm");
  }
  const std::int64_t columns =
      *std::max_element(options.footprint_divisors.begin(), options.footprint_divisors.end());
  const std::int64_t layers =
      options.pallet.z / *std::min_element(options.heights.begin(), options.heights.end());
  if (columns * layers > packing::kMaxItems) {
    found.push_back("footprint_divisors, heights: up to " + std::to_string(columns * layers) +
                    " items: at most " + std::to_string(packing::kMaxItems) + " are allowed");
  }
}

void checkCuts(const GeneratorOptions& options, std::vector<std::string>& found) {
  if (options.boxes < 1 || options.boxes > kMaxCutBoxes) {
    found.push_back("boxes: " + std::to_string(options.boxes) + ": must be 1 to " +
                    std::to_string(kMaxCutBoxes));
  }
  if (options.min_side < 1) {
    found.push_back("min_side: " + std::to_string(options.min_side) + " mm: must be positive");
  }
  if (!(options.spread >= 0.0 && options.spread <= 1.0)) {
    found.push_back("spread: " + std::to_string(options.spread) + ": must lie in [0, 1]");
  }
}

/// The size under which boxes that can be turned into each other are one type.
packing::Vec3 typeSize(packing::Vec3 size, const packing::Rotations& rotations) {
  if (rotations.vertical[0] && rotations.vertical[1] && size.y < size.z) std::swap(size.y, size.z);
  if (rotations.yaw && size.x < size.y) std::swap(size.x, size.y);
  if (rotations.vertical[0] && rotations.vertical[1] && size.y < size.z) std::swap(size.y, size.z);
  return size;
}

bool sameRotations(const packing::Rotations& a, const packing::Rotations& b) {
  return a.yaw == b.yaw && a.vertical == b.vertical;
}

std::string kindName(const GeneratorOptions& options) {
  std::string name;
  if (options.structure == PackingStructure::kColumns) name += "_columns";
  if (options.structure == PackingStructure::kCuts) name += "_cuts";
  if (options.continuous_heights) name += "_continuous";
  if (sameRotations(options.rotations, packing::Rotations::yawOnly())) name += "_yaw";
  if (sameRotations(options.rotations, packing::Rotations::any())) name += "_any";
  if (options.size_spread > 0) name += "_spread" + std::to_string(options.size_spread);
  if (options.gap > 0) name += "_gap" + std::to_string(options.gap);
  return name;
}

/// Makes the boxes the order of the instance, its known packing and, in loading order, its arrival.
void takeOrder(const std::vector<GuillotineFiller::Box>& boxes, const packing::Rotations& rotations,
               Instance& instance) {
  // Types in a stable order: large footprints first, then tall ones.
  std::map<std::tuple<std::int64_t, int, int>, int> type_of;
  const auto key = [&rotations](const packing::Vec3& placed) {
    const packing::Vec3 size = typeSize(placed, rotations);
    return std::make_tuple(-static_cast<std::int64_t>(size.x) * size.y, -size.x, -size.z);
  };
  for (const auto& box : boxes) type_of.emplace(key(box.size), 0);
  for (auto& entry : type_of) {
    entry.second = static_cast<int>(instance.order.types.size());
    instance.order.types.emplace_back();
  }
  instance.order.counts.assign(type_of.size(), 0);
  for (const auto& box : boxes) {
    const int type = type_of.at(key(box.size));
    packing::ItemType& item = instance.order.types[static_cast<std::size_t>(type)];
    item.size = typeSize(box.size, rotations);
    item.name = sizeName(item.size);
    item.rotations = rotations;
    ++instance.order.counts[static_cast<std::size_t>(type)];
    instance.perfect_packing.push_back({type, box.origin, box.size});
    instance.arrival.push_back(type);
  }
}

/// Draws the sides of every type anew, each within `spread` [mm] of its own and inside the pallet.
void spreadSizes(int spread, std::mt19937_64& rng, packing::Order& order) {
  std::uniform_int_distribution<int> by(-spread, spread);
  const auto drawn = [&](int side, int most) { return std::clamp(side + by(rng), 1, most); };
  for (packing::ItemType& type : order.types) {
    const packing::Vec3& pallet = order.rules.size;
    type.size.x = drawn(type.size.x, pallet.x);
    type.size.y = drawn(type.size.y, pallet.y);
    type.size.z = drawn(type.size.z, pallet.z);
    type.name += "_" + sizeName(type.size);
  }
}

std::vector<GuillotineFiller::Box> fillPallet(const GeneratorOptions& options, std::mt19937_64& rng) {
  if (options.structure == PackingStructure::kCuts) return cutBoxes(options, rng);
  GuillotineFiller filler(options, rng);
  filler.fill({0, 0, 0}, options.pallet, 1);
  return filler.boxes();
}

}  // namespace

std::optional<PackingStructure> packingStructureFromString(const std::string& word) {
  if (word == "columns") return PackingStructure::kColumns;
  if (word == "blocks") return PackingStructure::kBlocks;
  if (word == "cuts") return PackingStructure::kCuts;
  return std::nullopt;
}

packing::Vec3 footprint(const packing::Vec3& pallet, int divisor) {
  if (!isPowerOfTwo(divisor)) {
    throw std::invalid_argument("footprint: divisor " + std::to_string(divisor) + " is no power of two");
  }
  packing::Vec3 part{pallet.x, pallet.y, 0};
  for (; divisor > 1; divisor /= 2) part = halve(part).size;
  return part;
}

std::vector<std::string> problems(const GeneratorOptions& options) {
  std::vector<std::string> found;
  const packing::Vec3& pallet = options.pallet;
  for (const int side : {pallet.x, pallet.y, pallet.z}) {
    if (side < 1 || side > packing::kMaxPalletLength) {
      found.push_back("pallet: side of " + std::to_string(side) + " mm: must be 1 to " +
                      std::to_string(packing::kMaxPalletLength));
    }
  }
  if (options.n_pick < 1) found.push_back("n_pick: " + std::to_string(options.n_pick) + ": must be positive");
  if (!found.empty()) return found;
  const packing::Rotations& rotations = options.rotations;
  if (!sameRotations(rotations, {}) && !sameRotations(rotations, packing::Rotations::yawOnly()) &&
      !sameRotations(rotations, packing::Rotations::any())) {
    found.emplace_back("rotations: must be none, yaw or any");
  }
  if (options.size_spread < 0) {
    found.push_back("size_spread: " + std::to_string(options.size_spread) + " mm: must not be negative");
  }
  for (const std::string& line : packing::problems(rulesOf(options))) found.push_back(line);
  if (options.structure == PackingStructure::kCuts) {
    checkCuts(options, found);
    return found;
  }
  checkFootprints(options, found);
  checkHeights(options, found);
  return found;
}

Instance generateInstance(const GeneratorOptions& options, std::uint64_t seed, int index) {
  const std::vector<std::string> found = problems(options);
  if (!found.empty()) throw std::invalid_argument("generateInstance: options: " + joinFaults(found));
  std::seed_seq seeds{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                      static_cast<std::uint32_t>(index)};
  std::mt19937_64 rng(seeds);
  std::vector<GuillotineFiller::Box> boxes = fillPallet(options, rng);
  // Layer by layer: what stands lower is loaded first.
  std::sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) {
    return std::tie(a.origin.z, a.origin.y, a.origin.x) < std::tie(b.origin.z, b.origin.y, b.origin.x);
  });

  Instance instance;
  const std::string digits = std::to_string(index);
  instance.name = sizeName(options.pallet) + kindName(options) + "_seed" + std::to_string(seed) + "_" +
                  std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
  instance.order.rules = rulesOf(options);
  instance.n_pick = options.n_pick;
  takeOrder(boxes, options.rotations, instance);
  if (options.size_spread > 0) spreadSizes(options.size_spread, rng, instance.order);
  if (options.size_spread > 0 || options.gap > 0) instance.perfect_packing.clear();
  std::shuffle(instance.arrival.begin(), instance.arrival.end(), rng);
  return instance;
}

}  // namespace mixed_palletizing::instances
