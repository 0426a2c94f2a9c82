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

/// Sums of a plane h = c0 + c1 x + c2 y over weighted cells.
struct PlaneSums {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  void add(double weight, double x, double y, double h) {
    const Eigen::Vector3d v(1.0, x, y);
    squares += weight * v * v.transpose();
    products += weight * h * v;
  }
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
  parents_.assign(cells.size(), -1);
  for (int row = 0; row < cells.rows(); ++row) {
    for (int col = 0; col < cells.cols(); ++col) {
      const std::size_t here = cells.index(row, col);
      const Cell& cell = cells[here];
      if (cell.above == 0 || !active_[here] || !test.level(cell)) continue;
      parents_[here] = static_cast<int>(here);
      const auto meet = [&](std::size_t other) {
        if (parents_[other] < 0 || !test.together(cell, cells[other])) return;
        const int a = root(static_cast<int>(here));
        const int b = root(static_cast<int>(other));
        parents_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      };
      if (col > 0) meet(here - 1);
      if (row > 0) meet(here - static_cast<std::size_t>(cells.cols()));
    }
  }
}

void LevelPieces::measure(const CellGrid& cells, std::size_t first) {
  std::vector<PlaneSums> sums(pieces_.size());
  const auto forEach = [&](auto visit) {
    for (int row = 0; row < cells.rows(); ++row) {
      for (int col = 0; col < cells.cols(); ++col) {
        const int label = labels_[cells.index(row, col)];
        if (label >= static_cast<int>(first))
          visit(row, col, static_cast<std::size_t>(label), cells.at(row, col));
      }
    }
  };
  forEach([&](int row, int col, std::size_t label, const Cell& cell) {
    LevelPiece& piece = pieces_[label];
    const Eigen::Vector2d place(cell.x, cell.y);
    if (piece.points == 0) {
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
  for (std::size_t i = first; i < pieces_.size(); ++i) {
    LevelPiece& piece = pieces_[i];
    const double n = static_cast<double>(piece.points);
    piece.depth_m /= n;
    const Eigen::Vector3d plane = sums[i].squares.ldlt().solve(sums[i].products);
    const Eigen::Vector2d mean = sums[i].squares.block<2, 1>(1, 0) / n;
    piece.center += mean;
    piece.height_m = sums[i].products(0) / n;
    if (plane.allFinite()) piece.slope = plane.tail<2>();
  }
  forEach([&](int, int, std::size_t label, const Cell& cell) {
    LevelPiece& piece = pieces_[label];
    const double off = cell.height - piece.heightAt({cell.x, cell.y});
    piece.rms_m += cell.above * off * off;
  });
  for (std::size_t i = first; i < pieces_.size(); ++i) {
    pieces_[i].rms_m = std::sqrt(pieces_[i].rms_m / static_cast<double>(pieces_[i].points));
  }
}

/// Cells far from the middle height of their piece belong to something else that the piece leaked into: they leave
/// it, to be looked at again. Returns whether there are any.
bool LevelPieces::trim(const CellGrid& cells, const SensorNoise& noise, std::size_t first) {
  std::vector<std::vector<float>> heights(pieces_.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (labels_[i] >= static_cast<int>(first))
      heights[static_cast<std::size_t>(labels_[i])].push_back(cells[i].height);
  }
  const auto medianOf = [](std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  std::vector<std::pair<float, float>> kept(pieces_.size());  // middle and reach
  for (std::size_t p = first; p < pieces_.size(); ++p) {
    const float middle = medianOf(heights[p]);
    for (float& h : heights[p]) h = std::abs(h - middle);
    const double spread = kMadToSigma * static_cast<double>(medianOf(heights[p]));
    const double pixels = static_cast<double>(cells.cellPx());
    const double sigma = noise.depth(pieces_[p].depth_m) / pixels;
    kept[p] = {middle,
               static_cast<float>(std::max({kKeptSigmas * spread, kKeptSigmas * sigma, kLeastReach}))};
  }
  bool any = false;
  std::fill(active_.begin(), active_.end(), char{0});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (labels_[i] < static_cast<int>(first)) continue;
    const auto& [middle, reach] = kept[static_cast<std::size_t>(labels_[i])];
    if (std::abs(cells[i].height - middle) <= reach) continue;
    labels_[i] = -1;
    active_[i] = 1;
    any = true;
  }
  return any;
}

void LevelPieces::find(const CellGrid& cells, const SensorNoise& noise, std::size_t min_points) {
  pieces_.clear();
  labels_.assign(cells.size(), -1);
  active_.assign(cells.size(), 1);
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t first = pieces_.size();
    collect(cells, noise, min_points);
    measure(cells, first);
    if (pieces_.size() == first || !trim(cells, noise, first)) break;
  }
  for (LevelPiece& piece : pieces_) piece = LevelPiece();
  measure(cells, 0);
}

void LevelPieces::collect(const CellGrid& cells, const SensorNoise& noise, std::size_t min_points) {
  join(cells, noise);
  counts_.assign(cells.size(), Count{});
  const int cols = cells.cols();
  for (int row = 0; row < cells.rows(); ++row) {
    for (int col = 0; col < cols; ++col) {
      const std::size_t i = cells.index(row, col);
      if (parents_[i] < 0) continue;
      const int r = root(static_cast<int>(i));
      Count& count = counts_[static_cast<std::size_t>(r)];
      count.points += cells[i].above;
      ++count.cells;
      if (row == 0 || col == 0 || row + 1 == cells.rows() || col + 1 == cols) continue;
      const auto step = static_cast<std::size_t>(cols);
      bool core = true;
      for (const std::size_t k : {i - 1, i + 1, i - step, i + step}) {
        core = core && parents_[k] >= 0 && root(static_cast<int>(k)) == r;
      }
      count.core += core ? 1 : 0;
    }
  }
  numbers_.assign(cells.size(), -1);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (parents_[i] < 0) continue;
    const auto r = static_cast<std::size_t>(root(static_cast<int>(i)));
    const Count& count = counts_[r];
    if (count.points < min_points || count.core < kMinCore || count.core < kCoreShare * count.cells) continue;
    if (numbers_[r] < 0) {
      numbers_[r] = static_cast<int>(pieces_.size());
      pieces_.emplace_back();
    }
    labels_[i] = numbers_[r];
  }
}

}  // namespace mixed_palletizing::detection
