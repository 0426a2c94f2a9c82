#include "grid_runs.hpp"

namespace mixed_palletizing::detection {

void RunForest::clear() {
  runs_.clear();
  sorted_.clear();
  starts_.clear();
  row_ = -1;
  row_start_ = above_ = above_end_ = 0;
}

void RunForest::startRow(int row) {
  // Only the row directly above can touch this one.
  above_ = row == row_ + 1 ? row_start_ : runs_.size();
  above_end_ = runs_.size();
  row_start_ = runs_.size();
  row_ = row;
}

std::uint32_t RunForest::root(std::uint32_t run) {
  while (runs_[run].label != run) {
    runs_[run].label = runs_[runs_[run].label].label;  // halves the path
    run = runs_[run].label;
  }
  return run;
}

void RunForest::join(std::uint32_t a, std::uint32_t b) {
  a = root(a);
  b = root(b);
  // The older run stays the root, so that roots come first in row-major order.
  runs_[std::max(a, b)].label = std::min(a, b);
}

void RunForest::finish() {
  numbers_.assign(runs_.size(), 0);
  starts_.assign(1, 0);
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    if (root(i) != i) continue;
    numbers_[i] = static_cast<std::uint32_t>(starts_.size() - 1);
    starts_.push_back(0);
  }
  for (std::uint32_t i = 0; i < runs_.size(); ++i) ++starts_[numbers_[root(i)] + 1];
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  sorted_.resize(runs_.size());
  next_.assign(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    Run run = runs_[i];
    run.label = numbers_[root(i)];
    sorted_[next_[run.label]++] = run;
  }
}

}  // namespace mixed_palletizing::detection
