#include "guillotine.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace mixed_palletizing::instances {

Half halve(const packing::Vec3& part) {
  Half half{part, part.x >= part.y};
  int& side = half.along_x ? half.size.x : half.size.y;
  if (side % 2 != 0) {
    throw std::invalid_argument("side of " + std::to_string(side) + " mm cannot be halved");
  }
  side /= 2;
  return half;
}

std::vector<bool> reachableHeights(const std::vector<int>& heights, int total) {
  std::vector<bool> reachable(static_cast<std::size_t>(total) + 1, false);
  reachable[0] = true;
  for (int h = 1; h <= total; ++h) {
    for (const int height : heights) {
      if (height <= h && reachable[static_cast<std::size_t>(h - height)]) {
        reachable[static_cast<std::size_t>(h)] = true;
        break;
      }
    }
  }
  return reachable;
}

std::vector<int> heightsOf(const GeneratorOptions& options) {
  if (!options.continuous_heights || options.heights.empty()) return options.heights;
  const auto [lowest_at, highest_at] = std::minmax_element(options.heights.begin(), options.heights.end());
  const int lowest = *lowest_at;
  std::vector<int> heights(static_cast<std::size_t>(*highest_at - lowest) + 1);
  std::iota(heights.begin(), heights.end(), lowest);
  return heights;
}

GuillotineFiller::GuillotineFiller(const GeneratorOptions& options, std::mt19937_64& rng)
    : options_(options),
      heights_(heightsOf(options)),
      divisors_(options.footprint_divisors.begin(), options.footprint_divisors.end()),
      reachable_(reachableHeights(heights_, options.pallet.z)),
      rng_(rng) {}

void GuillotineFiller::fill(const packing::Vec3& origin, const packing::Vec3& size, int divisor) {
  if (options_.structure == PackingStructure::kBlocks && chance(kCutProbability)) {
    const std::vector<int> heights = cuts(size.z);
    if (!heights.empty()) {
      const int cut = oneOf(heights);
      fill(origin, {size.x, size.y, cut}, divisor);
      fill({origin.x, origin.y, origin.z + cut}, {size.x, size.y, size.z - cut}, divisor);
      return;
    }
  }
  const auto levels = static_cast<double>(std::distance(divisors_.lower_bound(divisor), divisors_.end()));
  if (divisors_.count(divisor) > 0 && chance(1.0 / levels)) {
    fillColumn(origin, size);
    return;
  }
  const Half half = halve(size);
  fill(origin, half.size, divisor * 2);
  fill({origin.x + (half.along_x ? half.size.x : 0), origin.y + (half.along_x ? 0 : half.size.y), origin.z},
       half.size, divisor * 2);
}

bool GuillotineFiller::chance(double probability) {
  return std::uniform_real_distribution<double>(0.0, 1.0)(rng_) < probability;
}

int GuillotineFiller::oneOf(const std::vector<int>& choices) {
  return choices[std::uniform_int_distribution<std::size_t>(0, choices.size() - 1)(rng_)];
}

void GuillotineFiller::fillColumn(packing::Vec3 origin, const packing::Vec3& size) {
  for (int rest = size.z; rest > 0;) {
    std::vector<int> fitting;
    for (const int height : heights_) {
      if (height <= rest && reachable_[static_cast<std::size_t>(rest - height)]) fitting.push_back(height);
    }
    const int height = oneOf(fitting);
    boxes_.push_back({origin, {size.x, size.y, height}});
    origin.z += height;
    rest -= height;
  }
}

std::vector<int> GuillotineFiller::cuts(int total) const {
  std::vector<int> found;
  for (int h = 1; h < total; ++h) {
    if (reachable_[static_cast<std::size_t>(h)] && reachable_[static_cast<std::size_t>(total - h)]) {
      found.push_back(h);
    }
  }
  return found;
}

std::vector<GuillotineFiller::Box> cutBoxes(const GeneratorOptions& options, std::mt19937_64& rng) {
  using Side = int packing::Vec3::*;
  const Side sides[] = {&packing::Vec3::x, &packing::Vec3::y, &packing::Vec3::z};
  const auto uniform = [&rng](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(rng);
  };
  const auto canBeCut = [&](const packing::Vec3& size, Side side) {
    return size.*side >= 2 * options.min_side;
  };
  std::vector<GuillotineFiller::Box> whole;  // that cannot be cut any more
  std::vector<GuillotineFiller::Box> boxes{{{0, 0, 0}, options.pallet}};
  while (!boxes.empty() && whole.size() + boxes.size() < static_cast<std::size_t>(options.boxes)) {
    const auto largest = std::max_element(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) {
      return packing::volume(a.size) < packing::volume(b.size);
    });
    GuillotineFiller::Box first = *largest;
    boxes.erase(largest);
    std::vector<double> weights;
    for (const Side side : sides) weights.push_back(canBeCut(first.size, side) ? first.size.*side : 0.0);
    if (*std::max_element(weights.begin(), weights.end()) <= 0.0) {
      whole.push_back(first);
      continue;
    }
    const Side side = sides[std::discrete_distribution<std::size_t>(weights.begin(), weights.end())(rng)];
    const int length = first.size.*side;
    const double share = uniform(0.5 - options.spread / 2.0, 0.5 + options.spread / 2.0);
    const int cut = std::clamp(static_cast<int>(share * length), options.min_side, length - options.min_side);
    GuillotineFiller::Box second = first;
    first.size.*side = cut;
    second.origin.*side += cut;
    second.size.*side -= cut;
    boxes.push_back(first);
    boxes.push_back(second);
  }
  boxes.insert(boxes.end(), whole.begin(), whole.end());
  return boxes;
}

}  // namespace mixed_palletizing::instances
