#include "level_pieces.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace mixed_palletizing::detection {
namespace {

constexpr double kFilled = 0.45;       // share of a cell's pixels that must lie above the floor
constexpr double kSpreadSigmas = 1.7;  // of the noise, granted to the spread within a cell
constexpr double kStepSigmas = 2.8;    // of a cell's mean, granted to a step between neighbours
constexpr double kSlope = 0.35;        // rise over run of the steepest level surface: bulges, dents
constexpr double kSlopeSpread = 0.7;   // spread of a steepest cell over its rise
constexpr double kRippleShare = 0.15;  // of the floor's ripple, which neighbouring cells may differ by
constexpr double kCoreShare = 0.15;    // of a piece's cells that have four neighbours of the same piece
constexpr int kMinCore = 3;
constexpr int kRounds = 3;              // of taking pieces apart that leaked into each other
constexpr double kMadToSigma = 1.4826;  // for normal values
constexpr double kKeptSigmas = 5.0;     // of a piece's heights around their middle
constexpr double kLeastReach = 0.0015;  // [m]
constexpr int kCounted = -2;            // less the number of a count: the label of a root that has one

/// What the cells of one cloud are held against.
class LevelTest {
 public:
  LevelTest(const CellGrid& cells, const SensorNoise& noise)
      : noise_(noise), cell_px_(cells.cellPx()), ripple_(kRippleShare * noise.ripple_m) {}

  bool level(const Cell& cell) const {
    if (cell.above < kFilled * cell_px_ * cell_px_ || cell.others > cell.above / 4) return false;
    const double pitch = cell_px_ * noise_.spacing(cell.depth);
    const double limit = kSpreadSigmas * noise_.depth(cell.depth) + kSlopeSpread * kSlope * pitch + ripple_;
    return cell.spread < limit;
  }

  bool together(const Cell& a, const Cell& b) const {
    const double step = std::abs(a.height - b.height);
    const double sigma = noise_.depth(a.depth) * std::sqrt(1.0 / a.above + 1.0 / b.above);
    const double limit = kStepSigmas * sigma + ripple_;
    if (step < limit) return true;
    return step < limit + kSlope * std::hypot(a.x - b.x, a.y - b.y);
  }

 private:
  const SensorNoise& noise_;
  int cell_px_;
  double ripple_;
};

}  // namespace

int LevelPieces::root(int cell) {
  while (parents_[static_cast<std::size_t>(cell)] != cell) {
    int& parent = parents_[static_cast<std::size_t>(cell)];
    parent = parents_[static_cast<std::size_t>(parent)];  // halves the path
    cell = parent;
  }
  return cell;
}

void LevelPieces::join(const CellGrid& cells, const SensorNoise& noise) {
  const LevelTest test(cells, noise);
  cells.forEachFilled([&](std::size_t here, int row, int col) {
    const Cell& cell = cells[here];
    parents_[here] = -1;
    if (!active_[here] || !test.level(cell)) return;
    parents_[here] = static_cast<int>(here);
    const auto meet = [&](std::size_t other) {
      if (parents_[other] < 0 || !test.together(cell, cells[other])) return;
      const int a = root(static_cast<int>(here));
      const int b = root(static_cast<int>(other));
      parents_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    };
    if (col > 0) meet(here - 1);
    if (row > 0) meet(here - static_cast<std::size_t>(cells.cols()));
  });
}

void LevelPieces::measure(const CellGrid& cells) {
  std::vector<PlaneSums>& sums = sums_;
  sums.assign(pieces_.size(), PlaneSums());
  const auto forEach = [&](auto visit) {
    cells.forEachFilled([&](std::size_t i, int row, int col) {
      if (labels_[i] >= 0) visit(i, row, col, static_cast<std::size_t>(labels_[i]));
    });
  };
  forEach([&](std::size_t i, int row, int col, std::size_t label) {
    const Cell& cell = cells[i];
    LevelPiece& piece = pieces_[label];
    const Eigen::Vector2d place(cell.x, cell.y);
    if (piece.points == 0) {
      piece.cell = i;
      piece.row_min = row;
      piece.col_min = piece.col_max = col;
      piece.low = piece.high = piece.center = place;  // the centre: kept as the origin of the sums
    }
    piece.row_max = row;
    piece.col_min = std::min(piece.col_min, col);
    piece.col_max = std::max(piece.col_max, col);
    piece.low = piece.low.cwiseMin(place);
    piece.high = piece.high.cwiseMax(place);
    piece.points += cell.above;
    piece.depth_m += cell.above * static_cast<double>(cell.depth);
    const Eigen::Vector2d d = place - piece.center;
    sums[label].add(cell.above, d.x(), d.y(), cell.height);
  });
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    LevelPiece& piece = pieces_[i];
    const double n = static_cast<double>(piece.points);
    piece.depth_m /= n;
    const Eigen::Vector3d plane = sums[i].squares.ldlt().solve(sums[i].products);
    const Eigen::Vector2d mean = sums[i].squares.block<2, 1>(1, 0) / n;
    piece.center += mean;
    piece.height_m = sums[i].products(0) / n;
    if (plane.allFinite()) piece.slope = plane.tail<2>();
  }
  forEach([&](std::size_t i, int, int, std::size_t label) {
    const Cell& cell = cells[i];
    LevelPiece& piece = pieces_[label];
    const double off = cell.height - piece.heightAt({cell.x, cell.y});
    piece.rms_m += cell.above * off * off;
  });
  for (LevelPiece& piece : pieces_) piece.rms_m = std::sqrt(piece.rms_m / static_cast<double>(piece.points));
}

/// Cells far from the middle height of their piece belong to something else that the piece leaked into: they leave
/// it, to be looked at again. Returns whether there are any.
bool LevelPieces::trim(const CellGrid& cells, const SensorNoise& noise, std::size_t first) {
  starts_.assign(1, 0);
  for (std::size_t p = first; p < pieces_.size(); ++p) starts_.push_back(starts_.back() + sizes_[p]);
  heights_.resize(starts_.back());
  std::vector<std::size_t>& next = next_;
  next.assign(starts_.begin(), starts_.end() - 1);
  cells.forEachFilled([&](std::size_t i, int, int) {
    if (labels_[i] < static_cast<int>(first)) return;
    heights_[next[static_cast<std::size_t>(labels_[i]) - first]++] = cells[i].height;
  });
  const auto medianOf = [&](std::size_t p) {
    const auto begin = heights_.begin() + static_cast<std::ptrdiff_t>(starts_[p - first]);
    const auto end = heights_.begin() + static_cast<std::ptrdiff_t>(starts_[p - first + 1]);
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end);
    return *middle;
  };
  kept_.resize(pieces_.size());
  for (std::size_t p = first; p < pieces_.size(); ++p) {
    const float middle = medianOf(p);
    for (std::size_t i = starts_[p - first]; i < starts_[p - first + 1]; ++i)
      heights_[i] = std::abs(heights_[i] - middle);
    const double spread = kMadToSigma * static_cast<double>(medianOf(p));
    const double sigma = noise.depth(pieces_[p].depth_m) / static_cast<double>(cells.cellPx());
    kept_[p] = {middle,
                static_cast<float>(std::max({kKeptSigmas * spread, kKeptSigmas * sigma, kLeastReach}))};
  }
  bool any = false;
  cells.forEachFilled([&](std::size_t i, int, int) {
    active_[i] = 0;
    if (labels_[i] < static_cast<int>(first)) return;
    const auto& [middle, reach] = kept_[static_cast<std::size_t>(labels_[i])];
    if (std::abs(cells[i].height - middle) <= reach) return;
    labels_[i] = -1;
    active_[i] = 1;
    any = true;
  });
  return any;
}

void LevelPieces::find(const CellGrid& cells, const SensorNoise& noise, std::size_t min_points) {
  pieces_.clear();
  sizes_.clear();
  labels_.assign(cells.size(), -1);
  parents_.assign(cells.size(), -1);
  active_.assign(cells.size(), 1);
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t first = pieces_.size();
    collect(cells, noise, min_points);
    if (pieces_.size() == first || !trim(cells, noise, first)) break;
  }
  for (LevelPiece& piece : pieces_) piece = LevelPiece();
  measure(cells);
}

/// Adds the pieces that are large and thick enough among the active cells.
void LevelPieces::collect(const CellGrid& cells, const SensorNoise& noise, std::size_t min_points) {
  join(cells, noise);
  // Links lead to cells before their own: in this order each cell's link is a root by now.
  cells.forEachFilled([&](std::size_t i, int, int) {
    if (parents_[i] >= 0) parents_[i] = parents_[static_cast<std::size_t>(parents_[i])];
  });
  counts_.clear();
  const auto countOf = [&](std::size_t root) -> Count& {
    return counts_[static_cast<std::size_t>(kCounted - labels_[root])];
  };
  const auto step = static_cast<std::size_t>(cells.cols());
  cells.forEachFilled([&](std::size_t i, int row, int col) {
    if (parents_[i] < 0) return;
    const auto r = static_cast<std::size_t>(parents_[i]);
    if (r == i) {
      labels_[i] = kCounted - static_cast<int>(counts_.size());
      counts_.push_back(Count{i});
    }
    Count& count = countOf(r);
    count.points += cells[i].above;
    count.depth += cells[i].above * static_cast<double>(cells[i].depth);
    ++count.cells;
    if (row == 0 || col == 0 || row + 1 == cells.rows() || col + 1 == cells.cols()) return;
    bool core = true;
    for (const std::size_t k : {i - 1, i + 1, i - step, i + step}) core = core && parents_[k] == parents_[i];
    count.core += core ? 1 : 0;
  });
  for (Count& count : counts_) {
    if (count.points < min_points || count.core < kMinCore || count.core < kCoreShare * count.cells) continue;
    count.piece = static_cast<int>(pieces_.size());
    pieces_.emplace_back();
    pieces_.back().depth_m = count.depth / static_cast<double>(count.points);
    sizes_.push_back(static_cast<std::size_t>(count.cells));
  }
  cells.forEachFilled([&](std::size_t i, int, int) {
    if (parents_[i] >= 0 && parents_[i] != static_cast<int>(i))
      labels_[i] = countOf(static_cast<std::size_t>(parents_[i])).piece;
  });
  for (const Count& count : counts_) labels_[count.root] = count.piece;
}

}  // namespace mixed_palletizing::detection
