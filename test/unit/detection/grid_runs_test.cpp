#include "grid_runs.hpp"

#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mixed_palletizing::detection {
namespace {

/// A random grid whose neighbours in the set belong together where `row_link` and `col_link` say so.
struct Grid {
  int width = 0;
  int height = 0;
  std::vector<char> set, row_link, col_link;  // links to the left and to the upper neighbour

  std::size_t at(int row, int col) const { return static_cast<std::size_t>(row * width + col); }
};

Grid randomGrid(std::mt19937& rng) {
  Grid grid;
  grid.width = 1 + static_cast<int>(rng() % 40);
  grid.height = 1 + static_cast<int>(rng() % 40);
  const unsigned fill = 1 + static_cast<unsigned>(rng() % 9);
  const auto size = static_cast<std::size_t>(grid.width * grid.height);
  for (std::size_t i = 0; i < size; ++i) {
    grid.set.push_back(rng() % 10 < fill);
    grid.row_link.push_back(rng() % 10 < 8);
    grid.col_link.push_back(rng() % 10 < 8);
  }
  return grid;
}

void fill(const Grid& grid, RunForest& forest) {
  forest.clear();
  for (int row = 0; row < grid.height; ++row) {
    const auto connected = [&](int col) { return grid.col_link[grid.at(row, col)] != 0; };
    int begin = -1;
    for (int col = 0; col <= grid.width; ++col) {
      const bool inside = col < grid.width && grid.set[grid.at(row, col)];
      if (begin >= 0 && (!inside || !grid.row_link[grid.at(row, col)])) {
        forest.add(row, begin, col, connected);
        begin = -1;
      }
      if (inside && begin < 0) begin = col;
    }
  }
  forest.finish();
}

/// Labels by repeated spreading: slow and simple.
std::vector<int> spreadLabels(const Grid& grid) {
  std::vector<int> label(grid.set.size(), -1);
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (grid.set[i]) label[i] = static_cast<int>(i);
  }
  for (bool changed = true; changed;) {
    changed = false;
    const auto join = [&](std::size_t a, std::size_t b) {
      if (label[a] == label[b]) return;
      label[a] = label[b] = std::min(label[a], label[b]);
      changed = true;
    };
    for (int row = 0; row < grid.height; ++row) {
      for (int col = 0; col < grid.width; ++col) {
        const std::size_t here = grid.at(row, col);
        if (!grid.set[here]) continue;
        if (col > 0 && grid.set[here - 1] && grid.row_link[here]) join(here, here - 1);
        if (row > 0 && grid.set[grid.at(row - 1, col)] && grid.col_link[here])
          join(here, grid.at(row - 1, col));
      }
    }
  }
  return label;
}

TEST(RunForest, findsTheSameComponentsAsSpreadingLabels) {
  std::mt19937 rng(21);
  RunForest forest;  // one for all cases: what it keeps must not leak into the next
  for (int i = 0; i < 400; ++i) {
    const Grid grid = randomGrid(rng);
    fill(grid, forest);
    const std::vector<int> expected = spreadLabels(grid);
    std::map<int, std::size_t> component_of;
    std::size_t pixels = 0;
    for (std::size_t c = 0; c < forest.componentCount(); ++c) {
      int before = -1;
      for (const auto& run : forest.component(c)) {
        ASSERT_GT(run.row * grid.width + run.begin, before) << "seed 21, case " << i;
        before = run.row * grid.width + run.begin;
        for (int col = run.begin; col < run.end; ++col) {
          const int label = expected[grid.at(run.row, col)];
          ASSERT_GE(label, 0) << "seed 21, case " << i;
          ASSERT_EQ(component_of.emplace(label, c).first->second, c) << "seed 21, case " << i;
          ++pixels;
        }
      }
    }
    EXPECT_EQ(component_of.size(), forest.componentCount()) << "seed 21, case " << i;
    EXPECT_EQ(pixels, static_cast<std::size_t>(std::count(grid.set.begin(), grid.set.end(), 1)));
  }
}

TEST(RunForest, isEmptyWithoutRuns) {
  RunForest forest;
  EXPECT_EQ(forest.componentCount(), 0u);
  forest.finish();
  EXPECT_EQ(forest.componentCount(), 0u);
}

}  // namespace
}  // namespace mixed_palletizing::detection
