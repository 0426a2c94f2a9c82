#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/instances/files.hpp>

#include "support.hpp"

namespace mixed_palletizing::instances {
namespace {

GeneratorOptions randomOptions(std::mt19937_64& rng) {
  GeneratorOptions options;
  const auto draw = [&rng](int low, int high) { return std::uniform_int_distribution<int>(low, high)(rng); };
  options.pallet = {16 * draw(10, 80), 16 * draw(10, 80), 0};
  options.footprint_divisors.clear();
  for (int divisor = 1; divisor <= 64; divisor *= 2) {
    if (draw(0, 2) == 0) options.footprint_divisors.push_back(divisor);
  }
  if (options.footprint_divisors.empty()) options.footprint_divisors = {4};
  options.heights.clear();
  for (int i = draw(1, 4); i > 0; --i) options.heights.push_back(draw(60, 300));
  for (const int height : options.heights) options.pallet.z += height * draw(1, 2);
  options.structure = draw(0, 1) == 0 ? PackingStructure::kColumns : PackingStructure::kBlocks;
  options.n_pick = draw(1, 5);
  return options;
}

TEST(Generator, makesPerfectPackings) {
  std::mt19937_64 rng(11);
  for (int i = 0; i < 300; ++i) {
    const GeneratorOptions options = randomOptions(rng);
    ASSERT_TRUE(problems(options).empty()) << problems(options).front();
    const Instance instance = generateInstance(options, 5, i);
    EXPECT_TRUE(problems(instance).empty()) << "case " << i << ": " << problems(instance).front();
    EXPECT_EQ(instance.order.itemVolume(), packing::volume(options.pallet)) << "case " << i;
    EXPECT_EQ(instance.perfect_packing.size(), instance.arrival.size());
    const std::vector<std::string> faults = checkResult(instance, test::perfectResult(instance));
    EXPECT_TRUE(faults.empty()) << "case " << i << ": " << faults.front();
    for (const packing::ItemType& type : instance.order.types) {
      bool known = false;
      for (const int divisor : options.footprint_divisors) {
        const packing::Vec3 part = footprint(options.pallet, divisor);
        known = known || (part.x == type.size.x && part.y == type.size.y);
      }
      EXPECT_TRUE(known) << "case " << i << ": footprint of " << type.name;
    }
  }
}

TEST(Generator, repeatsItselfAndDiffersBySeedAndIndex) {
  const GeneratorOptions options;
  std::set<std::vector<int>> arrivals;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(generateInstance(options, 3, i).arrival, generateInstance(options, 3, i).arrival);
    arrivals.insert(generateInstance(options, 3, i).arrival);
    arrivals.insert(generateInstance(options, 4, i).arrival);
  }
  EXPECT_EQ(arrivals.size(), 40U);
}

TEST(Generator, usesTheFootprintsOfTheThesis) {
  const packing::Vec3 pallet{1200, 800, 600};
  EXPECT_EQ(footprint(pallet, 4), (packing::Vec3{600, 400, 0}));
  EXPECT_EQ(footprint(pallet, 8), (packing::Vec3{300, 400, 0}));
  EXPECT_EQ(footprint(pallet, 16), (packing::Vec3{300, 200, 0}));
  std::set<std::string> names;
  for (int i = 0; i < 50; ++i) {
    for (const packing::ItemType& type : generateInstance({}, 1, i).order.types) names.insert(type.name);
  }
  EXPECT_EQ(names.size(), 9U);
  EXPECT_TRUE(names.count("300x200x100") == 1 && names.count("600x400x300") == 1);
}

TEST(Generator, refusesBadOptions) {
  const auto refused = [](const GeneratorOptions& options) {
    EXPECT_FALSE(problems(options).empty());
    EXPECT_THROW(generateInstance(options, 1, 0), std::invalid_argument);
  };
  GeneratorOptions options;
  for (const int z : {0, -600, 650, 1 << 30}) {
    options = {};
    options.pallet.z = z;
    refused(options);
  }
  for (const std::vector<int>& divisors : {std::vector<int>{}, {3}, {0}, {-4}, {4, 1 << 30}, {128}}) {
    options = {};
    options.pallet.y = 801;
    options.footprint_divisors = divisors;
    refused(options);
  }
  for (const std::vector<int>& heights : {std::vector<int>{}, {0}, {-100}, {7}, {601}}) {
    options = {};
    options.heights = heights;
    refused(options);
  }
  options = {};
  options.n_pick = 0;
  refused(options);
  options = {};
  options.pallet = {16384, 16384, 20000};
  options.footprint_divisors = {1 << 20};
  options.heights = {1};
  refused(options);  // 2 * 10^10 items
  EXPECT_THROW(footprint({1200, 800, 600}, 6), std::invalid_argument);
  EXPECT_FALSE(packingStructureFromString("pyramid"));
}

TEST(Arrival, isTheGivenOneOrDrawnFromTheSeed) {
  Instance instance = generateInstance({}, 1, 0);
  EXPECT_EQ(arrivalOf(instance, 7), instance.arrival);
  instance.arrival.clear();
  EXPECT_EQ(itemTypes(instance), expandedItems(instance.order));
  std::vector<int> drawn = arrivalOf(instance, 7);
  EXPECT_EQ(drawn, arrivalOf(instance, 7));
  EXPECT_NE(drawn, arrivalOf(instance, 8));
  std::sort(drawn.begin(), drawn.end());
  EXPECT_EQ(drawn, expandedItems(instance.order));
}

TEST(Generator, furtherKindsHavePerfectPackingsToo) {
  std::vector<GeneratorOptions> kinds(6);
  kinds[0].continuous_heights = true;
  kinds[1].structure = PackingStructure::kColumns;
  kinds[1].continuous_heights = true;
  kinds[1].rotations = packing::Rotations::yawOnly();
  kinds[2].structure = PackingStructure::kCuts;
  kinds[3].structure = PackingStructure::kCuts;
  kinds[3].rotations = packing::Rotations::any();
  kinds[3].spread = 1.0;
  kinds[4].structure = PackingStructure::kCuts;
  kinds[4].rotations = packing::Rotations::yawOnly();
  kinds[4].spread = 0.0;
  kinds[5].rotations = packing::Rotations::any();
  std::set<std::string> names;
  for (const GeneratorOptions& options : kinds) {
    for (int index = 0; index < 30; ++index) {
      const Instance instance = generateInstance(options, 51, index);
      EXPECT_TRUE(names.insert(instance.name).second) << instance.name;
      EXPECT_EQ(joinFaults(problems(instance)), "") << instance.name;
      EXPECT_EQ(instance.order.itemVolume(), packing::volume(options.pallet)) << instance.name;
      EXPECT_EQ(formatInstance(parseInstance(formatInstance(instance))), formatInstance(instance));
      for (const packing::Placement& p : instance.perfect_packing) {
        if (options.structure != PackingStructure::kCuts) continue;
        EXPECT_GE(std::min({p.size.x, p.size.y, p.size.z}), options.min_side);
      }
      if (options.structure == PackingStructure::kCuts) {
        EXPECT_EQ(instance.order.itemCount(), options.boxes) << instance.name;
      }
    }
  }
}

TEST(Generator, spreadsSizesAndSetsRules) {
  GeneratorOptions options;
  const Instance plain = generateInstance(options, 14, 0);
  options.size_spread = 10;
  options.gap = 5;
  options.min_support_ratio = 0.75;
  const Instance spread = generateInstance(options, 14, 0);
  EXPECT_TRUE(problems(spread).empty());
  EXPECT_TRUE(spread.perfect_packing.empty());
  EXPECT_EQ(spread.order.rules.gap, 5);
  EXPECT_EQ(spread.order.rules.min_support_ratio, 0.75);
  EXPECT_EQ(spread.order.counts, plain.order.counts);
  bool changed = false;
  for (std::size_t t = 0; t < plain.order.types.size(); ++t) {
    const packing::Vec3& before = plain.order.types[t].size;
    const packing::Vec3& after = spread.order.types[t].size;
    changed = changed || after != before;
    for (const int by : {after.x - before.x, after.y - before.y, after.z - before.z})
      EXPECT_LE(std::abs(by), 10);
  }
  EXPECT_TRUE(changed);
  options.size_spread = -1;
  options.gap = -1;
  options.min_support_ratio = 2.0;
  EXPECT_EQ(problems(options).size(), 3U);
}

TEST(Generator, refusesKindsThatCannotBeMade) {
  for (int broken = 0; broken < 6; ++broken) {
    GeneratorOptions options;
    options.structure = PackingStructure::kCuts;
    if (broken == 0) options.boxes = 0;
    if (broken == 1) options.boxes = 100000000;
    if (broken == 2) options.min_side = 0;
    if (broken == 3) options.spread = std::nan("");
    if (broken == 4) options.spread = 1.1;
    if (broken == 5) options.rotations = {false, {true, false, false}};
    EXPECT_EQ(problems(options).size(), 1U) << broken;
    EXPECT_THROW(generateInstance(options, 1, 0), std::invalid_argument);
  }
}

}  // namespace
}  // namespace mixed_palletizing::instances
