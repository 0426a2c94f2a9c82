#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/tuning_orders.hpp>

namespace mixed_palletizing::adapters {
namespace {

TEST(TuningOrders, areSoundAndNewInEveryIteration) {
  TuningMixture mixture;
  mixture.count = 2;
  const auto first = tuningOrders(mixture, 0);
  const auto second = tuningOrders(mixture, 1);
  ASSERT_EQ(first.size(), tuningKinds().size() * mixture.heights.size() * 2);
  ASSERT_EQ(second.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_TRUE(packing::problems(first[i].order).empty());
    EXPECT_EQ(static_cast<int>(first[i].arrival.size()), first[i].order.itemCount());
  }
  EXPECT_NE(first.front().arrival, second.front().arrival);
  EXPECT_EQ(tuningOrders(mixture, 0).front().arrival, first.front().arrival);
}

TEST(TuningOrders, refuseABadMixture) {
  TuningMixture mixture;
  mixture.kinds = {"blocks", "pyramids"};
  mixture.heights = {-1};
  mixture.count = 0;
  EXPECT_EQ(problems(mixture).size(), 3U);
  EXPECT_THROW(tuningOrders(mixture, 0), std::invalid_argument);
  mixture = {};
  mixture.kinds.clear();
  EXPECT_EQ(problems(mixture).size(), 1U);
}

}  // namespace
}  // namespace mixed_palletizing::adapters
