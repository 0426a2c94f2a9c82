#include <algorithm>
#include <chrono>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/order_packing.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>

#include "random_play.hpp"

namespace mixed_palletizing::packing {
namespace {

using test::draw;

struct Case {
  Order order;
  std::vector<int> items;
};

Case randomCase(std::mt19937_64& rng) {
  Case c;
  c.order.rules.size = {draw(rng, 20, 40), draw(rng, 20, 40), draw(rng, 20, 40)};
  c.order.rules.gap = draw(rng, 0, 3) / 3;
  c.order.rules.min_support_ratio = draw(rng, 0, 3) == 0 ? 0.8 : 1.0;
  const Rotations kinds[] = {Rotations::none(), Rotations::yawOnly(), Rotations::any()};
  for (int t = draw(rng, 1, 6); t > 0; --t) {
    c.order.types.push_back({"", {draw(rng, 4, 15), draw(rng, 4, 15), draw(rng, 4, 15)}, kinds[rng() % 3]});
    c.order.counts.push_back(draw(rng, 0, 8));
    c.items.insert(c.items.end(), static_cast<std::size_t>(c.order.counts.back()),
                   static_cast<int>(c.order.types.size()) - 1);
  }
  std::shuffle(c.items.begin(), c.items.end(), rng);
  return c;
}

/// Placements that keep every rule one after the other; every item packed or unpacked, once.
void expectSound(const Case& c, const OrderPacking& packing) {
  PalletState state(c.order.rules);
  std::vector<int> used = packing.unpacked;
  for (const PackedItem& packed : packing.packed) {
    ASSERT_EQ(c.items.at(static_cast<std::size_t>(packed.item)), packed.placement.type);
    const auto sizes = orientations(c.order.types[static_cast<std::size_t>(packed.placement.type)]);
    ASSERT_NE(std::find(sizes.begin(), sizes.end(), packed.placement.size), sizes.end());
    ASSERT_EQ(state.whyNot(packed.placement), "");
    state.place(packed.placement);
    used.push_back(packed.item);
  }
  std::sort(used.begin(), used.end());
  ASSERT_EQ(used.size(), c.items.size());
  for (std::size_t i = 0; i < used.size(); ++i) ASSERT_EQ(used[i], static_cast<int>(i));
  EXPECT_DOUBLE_EQ(packing.utilization, state.utilization());
}

/// A stop callback that counts to `calls`, so that runs can be repeated.
StopCallback stopAfter(int calls) {
  return [calls, asked = 0]() mutable { return ++asked > calls; };
}

TEST(PackOrder, isSoundAndRepeatableByEveryMethod) {
  std::mt19937_64 rng(1);
  for (int round = 0; round < 60; ++round) {
    const Case c = randomCase(rng);
    for (const PackMethod method :
         {PackMethod::kDblf, PackMethod::kDistance, PackMethod::kGa, PackMethod::kBest}) {
      PackOptions options;
      options.method = method;
      options.seed = rng();
      const OrderPacking packing = packOrder(c.order, c.items, options, stopAfter(50));
      expectSound(c, packing);
      const OrderPacking again = packOrder(c.order, c.items, options, stopAfter(50));
      EXPECT_TRUE(std::equal(packing.packed.begin(), packing.packed.end(), again.packed.begin(),
                             again.packed.end(), [](const PackedItem& a, const PackedItem& b) {
                               return a.item == b.item && a.placement == b.placement;
                             }));
      ASSERT_FALSE(HasFailure()) << "seed 1, round " << round << ", method " << static_cast<int>(method);
    }
  }
}

TEST(PackOrder, reportsProgressThatNeverFalls) {
  std::mt19937_64 rng(2);
  for (int round = 0; round < 20; ++round) {
    const Case c = randomCase(rng);
    for (const PackMethod method : {PackMethod::kGa, PackMethod::kBest}) {
      PackOptions options;
      options.method = method;
      std::vector<double> seen;
      const OrderPacking packing =
          packOrder(c.order, c.items, options, stopAfter(200), [&](const PackProgress& p) {
            EXPECT_EQ(p.rounds, method == PackMethod::kGa ? options.genetic.generations : 0);
            seen.push_back(p.best_utilization);
          });
      EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end())) << "seed 2, round " << round;
      if (!seen.empty()) {
        EXPECT_GE(packing.utilization, seen.back());
      }
    }
  }
}

TEST(PackOrder, answersWhenStoppedAtOnce) {
  std::mt19937_64 rng(3);
  for (int round = 0; round < 50; ++round) {
    const Case c = randomCase(rng);
    expectSound(c, packOrder(c.order, c.items, PackOptions{}, [] { return true; }));
    ASSERT_FALSE(HasFailure()) << "seed 3, round " << round;
  }
}

TEST(PackOrder, refusesBadInput) {
  Order order;
  order.rules.size = {100, 100, 100};
  order.types = {{"A", {50, 50, 50}, {}}};
  order.counts = {1};
  const StopCallback at_once = [] { return true; };
  EXPECT_THROW(packOrder(order, {0}, PackOptions{}, {}), std::invalid_argument) << "best needs an end";
  EXPECT_TRUE(packOrder(order, {}, PackOptions{}, at_once).packed.empty());
  for (const PackMethod method :
       {PackMethod::kDblf, PackMethod::kDistance, PackMethod::kGa, PackMethod::kBest}) {
    PackOptions options;
    options.method = method;
    EXPECT_THROW(packOrder(order, {0, 1}, options, at_once), std::invalid_argument);
    EXPECT_THROW(packOrder(order, {-1}, options, at_once), std::invalid_argument);
    Order broken = order;
    broken.rules.gap = -1;
    EXPECT_THROW(packOrder(broken, {0}, options, at_once), std::invalid_argument);
    broken = order;
    broken.types[0].size.y = 0;
    EXPECT_THROW(packOrder(broken, {0}, options, at_once), std::invalid_argument);
    options.genetic.population = 0;
    EXPECT_THROW(packOrder(order, {0}, options, at_once), std::invalid_argument);
  }
}

TEST(AssignItems, takesItemsOfATypeInOrderAndNoneTwice) {
  const Placement a{0, {0, 0, 0}, {1, 1, 1}};
  const Placement b{1, {0, 0, 1}, {1, 1, 1}};
  const OrderPacking packing = assignItems({b, a, b}, {0, 1, 1, 0}, 0.5);
  ASSERT_EQ(packing.packed.size(), 3U);
  EXPECT_EQ(packing.packed[0].item, 1);
  EXPECT_EQ(packing.packed[1].item, 0);
  EXPECT_EQ(packing.packed[2].item, 2);
  EXPECT_EQ(packing.unpacked, std::vector<int>{3});
  EXPECT_THROW(assignItems({a, a}, {0, 1}, 0.5), std::invalid_argument);
  EXPECT_THROW(assignItems({b}, {0}, 0.5), std::invalid_argument);
  EXPECT_THROW(assignItems({a}, {-1}, 0.5), std::invalid_argument);
}

TEST(PackMethod, isParsedFromItsWord) {
  EXPECT_EQ(packMethodFromString("dblf"), PackMethod::kDblf);
  EXPECT_EQ(packMethodFromString("distance"), PackMethod::kDistance);
  EXPECT_EQ(packMethodFromString("ga"), PackMethod::kGa);
  EXPECT_EQ(packMethodFromString("best"), PackMethod::kBest);
  EXPECT_FALSE(packMethodFromString("Best"));
}

}  // namespace
}  // namespace mixed_palletizing::packing
