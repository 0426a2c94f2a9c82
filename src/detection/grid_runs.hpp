// Connected components of grid pixels as runs of row pixels, joined by union-find.
//
// Source: thesis 3.2.2 "Clustering" after Trevor et al. 2013: every pixel is compared with its left and upper
// neighbour, labels that meet are merged by union-find, a second pass writes the final labels. Pixels that are
// connected along a row are kept as one run, so the forest holds a run where the thesis' holds a pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace mixed_palletizing::detection {

/// Pixels [begin, end) of one row.
struct Run {
  int row = 0;
  int begin = 0;
  int end = 0;
  std::uint32_t label = 0;

  int size() const { return end - begin; }
};

/// A component: runs in row-major order.
struct RunRange {
  const Run* first = nullptr;
  const Run* last = nullptr;

  const Run* begin() const { return first; }
  const Run* end() const { return last; }
};

class RunForest {
 public:
  /// Forgets the runs and keeps the memory.
  void clear();

  /// Adds a run after all runs before it in row-major order. `connected(col)` tells whether the pixel of this
  /// row and the one above it in column `col`, both in runs, belong together.
  template <typename Connected>
  void add(int row, int begin, int end, Connected connected);

  /// Groups the runs by component; components are numbered by their first run. To be called once, after the
  /// last run; O(runs).
  void finish();

  std::size_t componentCount() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  RunRange component(std::size_t i) const {
    return {sorted_.data() + starts_[i], sorted_.data() + starts_[i + 1]};
  }

 private:
  void startRow(int row);
  std::uint32_t root(std::uint32_t run);
  void join(std::uint32_t a, std::uint32_t b);

  std::vector<Run> runs_;               // label = parent until finish()
  std::vector<Run> sorted_;             // label = component
  std::vector<std::size_t> starts_;     // of the components in sorted_, and the end
  std::vector<std::size_t> next_;       // where the next run of each component goes in sorted_
  std::vector<std::uint32_t> numbers_;  // component of a root
  int row_ = -1;
  std::size_t row_start_ = 0;  // first run of the current row
  std::size_t above_ = 0;      // first run of the row above that may still meet new runs
  std::size_t above_end_ = 0;
};

/// Number of pixels of a component.
inline std::size_t pixelCount(const RunRange& runs) {
  std::size_t count = 0;
  for (const Run& run : runs) count += static_cast<std::size_t>(run.size());
  return count;
}

/// Step between rows and between columns that leaves some ten thousand pixels of a component of `count`: enough
/// for a mean.
inline int meanStride(std::size_t count) {
  constexpr double kEnough = 20000.0;
  return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count) / kEnough)));
}

template <typename Connected>
void RunForest::add(int row, int begin, int end, Connected connected) {
  if (row != row_) startRow(row);
  const auto index = static_cast<std::uint32_t>(runs_.size());
  runs_.push_back({row, begin, end, index});
  while (above_ < above_end_ && runs_[above_].end <= begin) ++above_;
  for (std::size_t i = above_; i < above_end_ && runs_[i].begin < end; ++i) {
    const int overlap_end = std::min(end, runs_[i].end);
    for (int col = std::max(begin, runs_[i].begin); col < overlap_end; ++col) {
      if (!connected(col)) continue;
      join(static_cast<std::uint32_t>(i), index);
      break;
    }
  }
}

}  // namespace mixed_palletizing::detection
