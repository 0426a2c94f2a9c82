#include "../../../src/packing/maximal_rectangles.hpp"

#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "brute_force.hpp"

namespace mixed_palletizing::packing {
namespace {

using Key = std::tuple<int, int, int, int>;

std::set<Key> keysOf(const std::vector<Rect>& rects) {
  std::set<Key> keys;
  for (const Rect& r : rects) keys.emplace(r.x0, r.y0, r.x1, r.y1);
  return keys;
}

std::set<Key> bruteForce(const std::vector<std::vector<char>>& cells) {
  const int width = static_cast<int>(cells.size());
  const int height = static_cast<int>(cells[0].size());
  std::set<Key> keys;
  for (int x0 = 0; x0 < width; ++x0) {
    for (int y0 = 0; y0 < height; ++y0) {
      for (int x1 = x0 + 1; x1 <= width; ++x1) {
        for (int y1 = y0 + 1; y1 <= height; ++y1) {
          if (test::isMaximal(cells, x0, y0, x1, y1)) keys.emplace(x0, y0, x1, y1);
        }
      }
    }
  }
  return keys;
}

TEST(MaximalRectangles, followRandomCutsAndAdditions) {
  std::mt19937_64 rng(5);
  for (int round = 0; round < 400; ++round) {
    const int width = 3 + static_cast<int>(rng() % 8);
    const int height = 3 + static_cast<int>(rng() % 8);
    std::vector<std::vector<char>> cells(static_cast<std::size_t>(width),
                                         std::vector<char>(static_cast<std::size_t>(height), 0));
    std::vector<Rect> rects;
    for (int step = 0; step < 40; ++step) {
      const int x0 = static_cast<int>(rng() % static_cast<unsigned>(width));
      const int y0 = static_cast<int>(rng() % static_cast<unsigned>(height));
      const Rect r{x0, y0, x0 + 1 + static_cast<int>(rng() % static_cast<unsigned>(width - x0)),
                   y0 + 1 + static_cast<int>(rng() % static_cast<unsigned>(height - y0))};
      const bool add = rng() % 2 == 0;
      for (int x = r.x0; x < r.x1; ++x) {
        for (int y = r.y0; y < r.y1; ++y)
          cells[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)] = add;
      }
      add ? addRect(rects, r) : cutOut(rects, r);
      ASSERT_EQ(keysOf(rects), bruteForce(cells)) << "seed 5, round " << round << ", step " << step;
      ASSERT_EQ(keysOf(rects).size(), rects.size()) << "a rectangle is listed twice";
    }
  }
}

TEST(MaximalRectangles, ignoreWhatIsEmptyOrOutside) {
  std::vector<Rect> rects{{0, 0, 4, 4}};
  cutOut(rects, {4, 0, 8, 4});
  cutOut(rects, {2, 2, 2, 3});
  addRect(rects, {1, 1, 1, 3});
  EXPECT_EQ(keysOf(rects), (std::set<Key>{{0, 0, 4, 4}}));
  addRect(rects, {6, 0, 7, 4});
  EXPECT_EQ(keysOf(rects), (std::set<Key>{{0, 0, 4, 4}, {6, 0, 7, 4}})) << "no touch, no merge";
}

}  // namespace
}  // namespace mixed_palletizing::packing
