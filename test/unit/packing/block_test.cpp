#include "../../../src/packing/block.hpp"

#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/pallet_state.hpp>

#include "random_play.hpp"

namespace mixed_palletizing::packing {
namespace {

using test::draw;

struct Stock {
  Vec3 pallet;
  std::vector<ItemType> types;
  std::vector<int> counts;
};

Stock randomStock(std::mt19937_64& rng) {
  Stock stock;
  stock.pallet = {draw(rng, 8, 20), draw(rng, 8, 20), draw(rng, 8, 20)};
  const Rotations kinds[] = {Rotations::none(), Rotations::yawOnly(), Rotations::any()};
  for (int t = draw(rng, 1, 4); t > 0; --t) {
    stock.types.push_back(
        {"", {draw(rng, 1, 4) * 2, draw(rng, 1, 4) * 2, draw(rng, 1, 4) * 2}, kinds[rng() % 3]});
    stock.counts.push_back(draw(rng, 0, 6));
  }
  return stock;
}

TEST(MakeBlocks, givesSolidLoadableCuboidsOfItemsThatAreThere) {
  std::mt19937_64 rng(1);
  for (int round = 0; round < 300; ++round) {
    const Stock stock = randomStock(rng);
    const std::vector<Block> blocks = makeBlocks(stock.types, stock.counts, stock.pallet, 500);
    ASSERT_LE(blocks.size(), 500U);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      std::vector<Placement> items;
      appendItems(blocks, b, {0, 0, 0}, items);
      ASSERT_EQ(items.size(), static_cast<std::size_t>(blocks[b].items));
      PalletState pallet(PalletRules{stock.pallet});
      std::vector<int> used(stock.types.size(), 0);
      for (const Placement& item : items) {
        ASSERT_EQ(pallet.whyNot(item), "") << "seed 1, round " << round << ", block " << b;
        pallet.place(item);
        ++used[static_cast<std::size_t>(item.type)];
        ASSERT_LE(item.origin.x + item.size.x, blocks[b].size.x);
        ASSERT_LE(item.origin.y + item.size.y, blocks[b].size.y);
        ASSERT_LE(item.origin.z + item.size.z, blocks[b].size.z);
      }
      ASSERT_EQ(pallet.packedVolume(), volume(blocks[b].size)) << "no holes";
      for (const TypeCount& need : blocks[b].needs) {
        ASSERT_EQ(used[static_cast<std::size_t>(need.type)], need.count);
        ASSERT_LE(need.count, stock.counts[static_cast<std::size_t>(need.type)]);
      }
    }
  }
}

TEST(MakeBlocks, givesEveryBoxOfOneTypeOnce) {
  const std::vector<Block> blocks = makeBlocks({{"A", {3, 4, 5}, {}}}, {12}, {9, 8, 10}, 10000);
  std::set<std::string> sizes;
  for (const Block& block : blocks) {
    sizes.insert(std::to_string(block.size.x) + "," + std::to_string(block.size.y) + "," +
                 std::to_string(block.size.z));
  }
  EXPECT_EQ(blocks.size(), 12U) << "3 x 2 x 2 sizes";
  EXPECT_EQ(sizes.size(), blocks.size());
}

TEST(MakeBlocks, leavesOutWhatIsNotThereOrTooLarge) {
  EXPECT_TRUE(makeBlocks({{"A", {3, 4, 5}, {}}}, {0}, {9, 8, 10}, 100).empty());
  EXPECT_TRUE(makeBlocks({{"A", {3, 4, 11}, {}}}, {5}, {9, 8, 10}, 100).empty());
  EXPECT_TRUE(makeBlocks({}, {}, {9, 8, 10}, 100).empty());
  EXPECT_EQ(makeBlocks({{"A", {3, 4, 5}, {}}}, {12}, {9, 8, 10}, 3).size(), 3U);
}

}  // namespace
}  // namespace mixed_palletizing::packing
