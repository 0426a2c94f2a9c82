#include "../../../src/packing/block_search.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/pallet_state.hpp>

#include "../../../src/packing/block_scorer.hpp"
#include "../../../src/packing/block_state.hpp"
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
  stock.pallet = {draw(rng, 8, 24), draw(rng, 8, 24), draw(rng, 8, 24)};
  const Rotations kinds[] = {Rotations::none(), Rotations::yawOnly(), Rotations::any()};
  for (int t = draw(rng, 1, 5); t > 0; --t) {
    stock.types.push_back({"", {draw(rng, 2, 8), draw(rng, 2, 8), draw(rng, 2, 8)}, kinds[rng() % 3]});
    stock.counts.push_back(draw(rng, 0, 9));
  }
  return stock;
}

/// Fills up to `blocks` spaces with random blocks of those that fit.
BlockState randomState(const BlockCatalog& catalog, const Stock& stock, std::mt19937_64& rng, int blocks) {
  BlockState state(catalog, stock.counts);
  for (int i = 0; i < blocks && !state.spaces().empty(); ++i) {
    const AnchoredSpace where{state.spaces()[rng() % state.spaces().size()], rng() % 2 == 0, rng() % 2 == 0};
    std::vector<std::size_t> fitting;
    for (const std::uint32_t rank : state.ranks()) {
      if (catalog.sizes[rank].fitsInto(PackedSize(where.space.size())))
        fitting.push_back(catalog.ranked[rank].index);
    }
    if (fitting.empty()) continue;
    const std::size_t block = fitting[rng() % fitting.size()];
    state.place(catalog, {block, where.originOf(catalog.blocks[block].size)});
  }
  return state;
}

/// The pallet that holds the blocks of a state item by item; every one must be valid.
PalletState asPallet(const BlockCatalog& catalog, const BlockState& state) {
  PalletState pallet(PalletRules{catalog.pallet});
  std::vector<Placement> items;
  for (const BlockStep& step : state.steps()) appendItems(catalog.blocks, step.block, step.origin, items);
  for (const Placement& item : items) {
    EXPECT_EQ(pallet.whyNot(item), "");
    pallet.place(item);
  }
  return pallet;
}

TEST(PackedSize, fitsLikeThreeComparisons) {
  std::mt19937_64 rng(4);
  for (int i = 0; i < 20000; ++i) {
    const int most = i % 2 == 0 ? 3 : kMaxPalletLength;
    const Vec3 a{draw(rng, 0, most), draw(rng, 0, most), draw(rng, 0, most)};
    const Vec3 b{draw(rng, 0, most), draw(rng, 0, most), draw(rng, 0, most)};
    ASSERT_EQ(PackedSize(a).fitsInto(PackedSize(b)), a.x <= b.x && a.y <= b.y && a.z <= b.z)
        << "seed 4, " << i;
  }
}

TEST(BlockState, holdsTheSpacesOfThePalletAndTheBlocksThatRemain) {
  std::mt19937_64 rng(1);
  for (int round = 0; round < 500; ++round) {
    const Stock stock = randomStock(rng);
    const BlockCatalog catalog = makeCatalog(stock.pallet, stock.types, stock.counts, 300, 0.2);
    const BlockState state = randomState(catalog, stock, rng, draw(rng, 0, 12));
    const PalletState pallet = asPallet(catalog, state);
    ASSERT_TRUE(pallet.spaces() == state.spaces()) << "seed 1, round " << round;
    ASSERT_EQ(pallet.packedVolume(), state.packedVolume());
    std::vector<int> left = stock.counts;
    for (const Placement& p : pallet.placements()) --left[static_cast<std::size_t>(p.type)];
    ASSERT_EQ(left, state.remaining());
    std::vector<std::uint32_t> ranks;
    for (std::uint32_t rank = 0; rank < catalog.ranked.size(); ++rank) {
      const std::vector<TypeCount>& needs = catalog.blocks[catalog.ranked[rank].index].needs;
      const auto there = [&](const TypeCount& n) {
        return n.count <= left[static_cast<std::size_t>(n.type)];
      };
      if (std::all_of(needs.begin(), needs.end(), there)) ranks.push_back(rank);
    }
    ASSERT_EQ(ranks, state.ranks()) << "seed 1, round " << round;
    for (const Space& space : state.spaces()) {
      bool fits = false;
      for (std::size_t t = 0; t < left.size(); ++t) {
        for (const Vec3& size : orientations(stock.types[t])) {
          fits = fits || (left[t] > 0 && PackedSize(size).fitsInto(PackedSize(space.size())));
        }
      }
      ASSERT_EQ(state.isUseful(space), fits) << "seed 1, round " << round;
    }
  }
}

TEST(ReachableLengths, areTheLongestSumsOfSides) {
  BlockCatalog catalog;
  catalog.pallet = {30, 20, 10};
  catalog.orientations = {{{7, 5, 3}}, {{4, 9, 6}, {9, 4, 6}}};
  const ReachableLengths lengths(catalog, {2, 1});
  const std::vector<int> along_x{0, 0, 0, 0, 4, 4, 4, 7, 7, 9, 9, 11, 11, 13, 14, 14, 16, 16, 18, 18, 20};
  for (int length = 0; length <= 20; ++length) {
    EXPECT_EQ(lengths.along(0, length), along_x[static_cast<std::size_t>(length)]) << length;
  }
  EXPECT_EQ(lengths.along(2, 10), 9) << "3 + 6";
  EXPECT_EQ(ReachableLengths(catalog, {0, 0}).along(0, 30), 0);
}

/// Share of the surface of a box that touches walls, floor, ceiling or boxes, by cells of 1 mm.
double touchingShare(const PalletState& pallet, const Vec3& origin, const Vec3& size) {
  const Vec3& room = pallet.rules().size;
  const auto solid = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= room.x || y >= room.y || z >= room.z) return true;
    return std::any_of(pallet.placements().begin(), pallet.placements().end(), [&](const Placement& p) {
      return x >= p.origin.x && x < p.origin.x + p.size.x && y >= p.origin.y && y < p.origin.y + p.size.y &&
             z >= p.origin.z && z < p.origin.z + p.size.z;
    });
  };
  int touching = 0;
  int cells = 0;
  const auto count = [&](int x, int y, int z) {
    ++cells;
    if (solid(x, y, z)) ++touching;
  };
  const Vec3 end{origin.x + size.x, origin.y + size.y, origin.z + size.z};
  for (int x = origin.x; x < end.x; ++x) {
    for (int y = origin.y; y < end.y; ++y) count(x, y, origin.z - 1), count(x, y, end.z);
    for (int z = origin.z; z < end.z; ++z) count(x, origin.y - 1, z), count(x, end.y, z);
  }
  for (int y = origin.y; y < end.y; ++y) {
    for (int z = origin.z; z < end.z; ++z) count(origin.x - 1, y, z), count(end.x, y, z);
  }
  return static_cast<double>(touching) / cells;
}

TEST(BlockScorer, ranksAsTheFormulaSays) {
  std::mt19937_64 rng(2);
  for (int round = 0; round < 150; ++round) {
    const Stock stock = randomStock(rng);
    const ScoreWeights weights{0.0, 0.2};
    const BlockCatalog catalog =
        makeCatalog(stock.pallet, stock.types, stock.counts, 60, weights.items_exponent);
    const ReachableLengths lengths(catalog, stock.counts);
    BlockScorer scorer(catalog, lengths, weights);
    const BlockState state = randomState(catalog, stock, rng, draw(rng, 0, 8));
    const PalletState pallet = asPallet(catalog, state);
    for (const Space& space : state.spaces()) {
      const AnchoredSpace where{space, rng() % 2 == 0, rng() % 2 == 0};
      const Vec3 room = space.size();
      std::vector<double> scores;
      for (const std::uint32_t rank : state.ranks()) {
        const Vec3& size = catalog.blocks[catalog.ranked[rank].index].size;
        if (size.x > room.x || size.y > room.y || size.z > room.z) continue;
        const double used = (size.x + lengths.along(0, room.x - size.x)) *
                            static_cast<double>(size.y + lengths.along(1, room.y - size.y)) *
                            (size.z + lengths.along(2, room.z - size.z));
        const double share = touchingShare(pallet, where.originOf(size), size);
        scores.push_back(catalog.ranked[rank].value * used / static_cast<double>(volume(room)) *
                         std::pow(share, 4));
      }
      std::sort(scores.rbegin(), scores.rend());
      const std::vector<ScoredBlock>& best = scorer.best(state, where, 5);
      ASSERT_EQ(best.size(), std::min<std::size_t>(5, scores.size())) << "seed 2, round " << round;
      for (std::size_t i = 0; i < best.size(); ++i) ASSERT_NEAR(best[i].score, scores[i], 1e-9 * scores[i]);
    }
  }
}

StopCallback stopAfter(int calls) {
  return [calls, asked = 0]() mutable { return ++asked > calls; };
}

TEST(BlockSearch, packsSoundlyAndTheSameAgain) {
  std::mt19937_64 rng(3);
  for (int round = 0; round < 100; ++round) {
    const Stock stock = randomStock(rng);
    BlockSearch search(stock.pallet, stock.types, stock.counts, {});
    BlockSearch again(stock.pallet, stock.types, stock.counts, {});
    std::int64_t last = 0;
    for (const std::size_t width : {1U, 2U, 4U}) {
      const SpaceOrder order = width == 2 ? SpaceOrder::kLowest : SpaceOrder::kNearest;
      const int calls = draw(rng, 0, 200);
      EXPECT_EQ(search.run(order, width, stopAfter(calls)), again.run(order, width, stopAfter(calls)));
      EXPECT_GE(search.bestVolume(), last) << "never worse";
      last = search.bestVolume();
    }
    PalletState pallet(PalletRules{stock.pallet});
    std::vector<int> left = stock.counts;
    for (const Placement& p : search.bestPlacements()) {
      ASSERT_EQ(pallet.whyNot(p), "") << "seed 3, round " << round;
      pallet.place(p);
      ASSERT_GE(--left[static_cast<std::size_t>(p.type)], 0);
    }
    EXPECT_EQ(pallet.packedVolume(), search.bestVolume());
    EXPECT_EQ(search.complete(), std::all_of(left.begin(), left.end(), [](int n) { return n == 0; }));
    EXPECT_TRUE(again.bestPlacements() == search.bestPlacements());
    ASSERT_FALSE(HasFailure()) << "seed 3, round " << round;
  }
}

TEST(BlockSearch, handlesNothingToPackAndNothingThatFits) {
  BlockSearch none({10, 10, 10}, {}, {}, {});
  EXPECT_TRUE(none.run(SpaceOrder::kNearest, 3, {}));
  EXPECT_TRUE(none.complete());
  BlockSearch large({10, 10, 10}, {{"A", {11, 1, 1}, {}}}, {2}, {});
  EXPECT_TRUE(large.run(SpaceOrder::kNearest, 3, {}));
  EXPECT_FALSE(large.complete());
  EXPECT_EQ(large.bestVolume(), 0);
  EXPECT_TRUE(large.bestPlacements().empty());
}

}  // namespace
}  // namespace mixed_palletizing::packing
