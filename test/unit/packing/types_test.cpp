#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {
namespace {

Order soundOrder() {
  Order order;
  order.rules.size = {1200, 800, 600};
  order.types = {{"A", {600, 400, 300}, {}}, {"B", {300, 200, 100}, {}}};
  order.counts = {2, 3};
  return order;
}

bool mentions(const std::vector<std::string>& lines, const std::string& word) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(word) != std::string::npos; });
}

TEST(Orientations, followTheRotationsAndAreDistinct) {
  ItemType type{"A", {30, 20, 10}, Rotations::none()};
  EXPECT_EQ(orientations(type), (std::vector<Vec3>{{30, 20, 10}}));
  type.rotations = Rotations::yawOnly();
  EXPECT_EQ(orientations(type), (std::vector<Vec3>{{30, 20, 10}, {20, 30, 10}}));
  type.rotations = Rotations::any();
  EXPECT_EQ(orientations(type).size(), 6U);
  EXPECT_EQ(orientations(type).front(), type.size);
  type.rotations = {true, {true, false, false}};
  EXPECT_EQ(orientations(type), (std::vector<Vec3>{{10, 20, 30}, {20, 10, 30}}));
  type.rotations = {false, {false, true, false}};
  EXPECT_EQ(orientations(type), (std::vector<Vec3>{{30, 10, 20}}));
  type = {"cube", {7, 7, 7}, Rotations::any()};
  EXPECT_EQ(orientations(type).size(), 1U);
  type.rotations = {true, {false, false, false}};
  EXPECT_TRUE(orientations(type).empty());
}

TEST(Order, countsItemsAndVolume) {
  const Order order = soundOrder();
  EXPECT_TRUE(problems(order).empty());
  EXPECT_EQ(order.itemCount(), 5);
  EXPECT_EQ(order.itemVolume(), 2 * 72000000 + 3 * 6000000);
}

TEST(Order, everyProblemIsNamed) {
  Order order = soundOrder();
  order.rules = {{0, 800, 600}, -1, 2.0};
  order.types.push_back({"A", {10, 10, 10}, {}});
  order.types.push_back({"flat", {10, 0, 10}, {}});
  order.types.push_back({"heavy", {10, 10, 10}, {}, -1.0, std::numeric_limits<double>::quiet_NaN()});
  order.types.push_back({"stuck", {10, 10, 10}, {true, {false, false, false}}});
  order.counts = {1, -2, 1};
  const auto lines = problems(order);
  for (const char* word :
       {"rules.size", "rules.gap", "min_support_ratio", "3 counts for 6 types", "given twice", "'flat'.size",
        "'heavy'.weight_kg", "'heavy'.max_load_kg", "'stuck'.rotations", "counts[1]"}) {
    EXPECT_TRUE(mentions(lines, word)) << word;
  }
}

TEST(Order, refusesWhatCannotBePacked) {
  Order order = soundOrder();
  order.types[0].size = {601, 801, 100};
  EXPECT_TRUE(mentions(problems(order), "larger than the pallet"));
  order.types[0].rotations = Rotations::yawOnly();
  EXPECT_TRUE(problems(order).empty());
  order.counts = {0, 0};
  EXPECT_TRUE(mentions(problems(order), "no items"));
  order.counts = {std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
  EXPECT_TRUE(mentions(problems(order), "at most"));
  EXPECT_TRUE(mentions(problems(Order{}), "no items"));
}

}  // namespace
}  // namespace mixed_palletizing::packing
