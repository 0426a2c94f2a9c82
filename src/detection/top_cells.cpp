// Height, evenness and tilt of a top from the cells well inside its rectangle.
#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "level_box.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr int kParts = 6;              // per side, for the evenness
constexpr double kInnerCells = 1.2;    // cells next to the sides that stay out
constexpr double kLargestInset = 0.2;  // of a side
constexpr double kReach = 0.02;        // [m] around the level: dents and bulges
constexpr double kReachBands = 3.0;
constexpr double kFilled = 0.5;      // share of a cell's pixels
constexpr double kFilledPart = 0.3;  // of the mean part
constexpr int kTrimRounds = 2;

void findInnerCells(const LevelContext& context, const TopGroup& group, const RectangleFit& fit,
                    double level_m, std::vector<SurfaceCell>& cells) {
  cells.clear();
  const int k = context.cells.cellPx();
  const geometry::Rectangle& r = fit.rectangle;
  const LevelPiece& piece = context.pieces.pieces()[static_cast<std::size_t>(group.largest)];
  const double cell_m = k * group.pixel_m;
  const double inset = std::max(kInnerCells * cell_m, fit.rounding_m + 0.5 * cell_m);
  const Eigen::Array2d inner = (0.5 * r.size.array() - inset).max((0.5 - kLargestInset) * r.size.array());
  const double reach = std::max(kReach, kReachBands * group.scale.band_m);
  const Eigen::Vector2d ax = r.axisX();
  const Eigen::Vector2d ay = r.axisY();
  for (int row = group.box.row_min / k; row <= group.box.row_max / k; ++row) {
    for (int col = group.box.col_min / k; col <= group.box.col_max / k; ++col) {
      const Cell& cell = context.cells.at(row, col);
      if (cell.above < kFilled * k * k || cell.others > 0) continue;
      if (std::abs(cell.height - level_m) > reach) continue;
      const Eigen::Vector2d d = Eigen::Vector2d(cell.x, cell.y) - r.center;
      const double x = d.dot(ax);
      const double y = d.dot(ay);
      if (std::abs(x) > inner.x() || std::abs(y) > inner.y()) continue;
      cells.push_back({x, y, cell.height, static_cast<double>(cell.above),
                       cell.height - piece.heightAt({cell.x, cell.y})});
    }
  }
}

/// What hides a top lies above it; what lies below are its dents.
void meanOf(const std::vector<SurfaceCell>& cells, double reach_m, TopSurface& surface) {
  double n = 0.0, sum = 0.0, squares = 0.0;
  std::size_t count = 0;
  for (const SurfaceCell& cell : cells) {
    const double off = cell.height - surface.height_m;
    if (cell.off > reach_m) continue;
    ++count;
    n += cell.weight;
    sum += cell.weight * off;
    squares += cell.weight * off * off;
  }
  if (n <= 0.0) return;
  surface.count = count;
  surface.stddev_m = std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)));
  surface.height_m += sum / n;
}

double unevenness(const std::vector<SurfaceCell>& cells, const geometry::Rectangle& r, double height_m) {
  std::array<double, kParts * kParts> sums{};
  std::array<double, kParts * kParts> weights{};
  double all = 0.0;
  for (const SurfaceCell& cell : cells) {
    const int i = std::clamp(static_cast<int>((cell.x / r.size.x() + 0.5) * kParts), 0, kParts - 1);
    const int k = std::clamp(static_cast<int>((cell.y / r.size.y() + 0.5) * kParts), 0, kParts - 1);
    const auto part = static_cast<std::size_t>(k * kParts + i);
    sums[part] += cell.weight * (cell.height - height_m);
    weights[part] += cell.weight;
    all += cell.weight;
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (weights[i] * kParts * kParts < kFilledPart * all || weights[i] <= 0.0) continue;
    largest = std::max(largest, std::abs(sums[i] / weights[i]));
  }
  return largest;
}

/// Slope of the plane that fits the cells best, along x and y of the base frame.
Eigen::Vector2d slopeOf(const std::vector<SurfaceCell>& cells, const geometry::Rectangle& r) {
  double n = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const SurfaceCell& cell : cells) {
    n += cell.weight;
    mean += cell.weight * Eigen::Vector3d(cell.x, cell.y, cell.height);
  }
  if (n <= 0.0) return Eigen::Vector2d::Zero();
  mean /= n;
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  Eigen::Vector2d products = Eigen::Vector2d::Zero();
  for (const SurfaceCell& cell : cells) {
    const Eigen::Vector2d d(cell.x - mean.x(), cell.y - mean.y());
    squares += cell.weight * d * d.transpose();
    products += cell.weight * (cell.height - mean.z()) * d;
  }
  if (!(squares.determinant() > 1e-9 * squares.trace() * squares.trace())) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d local = squares.inverse() * products;
  return local.x() * r.axisX() + local.y() * r.axisY();
}

/// What the strip along the sides, where cells stay out, takes from or adds to the mean of a surface that is not level:
/// by the parabola along both axes that fits the cells best. Rounded edges do not count.
double rimCorrection(const std::vector<SurfaceCell>& cells, const geometry::Rectangle& r, double rounding_m) {
  using Terms = Eigen::Matrix<double, 5, 1>;
  Eigen::Matrix<double, 5, 5> squares = Eigen::Matrix<double, 5, 5>::Zero();
  Terms products = Terms::Zero();
  for (const SurfaceCell& cell : cells) {
    const double u = 2.0 * cell.x / r.size.x();
    const double v = 2.0 * cell.y / r.size.y();
    const Terms terms = (Terms() << 1.0, u, v, u * u, v * v).finished();
    squares += cell.weight * terms * terms.transpose();
    products += cell.weight * (cell.height - cells.front().height) * terms;
  }
  if (!(squares(0, 0) > 0.0)) return 0.0;
  const Terms parabola = squares.ldlt().solve(products);
  if (!parabola.allFinite()) return 0.0;
  const Terms cells_mean = squares.col(0) / squares(0, 0);
  const Eigen::Array2d level = (1.0 - 2.0 * rounding_m / r.size.array()).max(0.0);
  const Eigen::Array2d squared = level * level / 3.0;  // mean of u^2 and v^2 up to there
  const Terms top_mean = (Terms() << 1.0, 0.0, 0.0, squared.x(), squared.y()).finished();
  return parabola.dot(top_mean - cells_mean);
}

/// Whether cells are seen all over the rectangle, so that nothing is guessed but its rim.
bool seenAllOver(const std::vector<SurfaceCell>& cells, const geometry::Rectangle& r) {
  std::array<bool, kParts * kParts> seen{};
  for (const SurfaceCell& cell : cells) {
    const int i = std::clamp(static_cast<int>((cell.x / r.size.x() + 0.5) * kParts), 0, kParts - 1);
    const int k = std::clamp(static_cast<int>((cell.y / r.size.y() + 0.5) * kParts), 0, kParts - 1);
    seen[static_cast<std::size_t>(k * kParts + i)] = true;
  }
  return std::all_of(seen.begin(), seen.end(), [](bool part) { return part; });
}

}  // namespace

TopSurface measureCells(const LevelContext& context, const TopGroup& group, const RectangleFit& fit,
                        double level_m, std::vector<SurfaceCell>& cells) {
  TopSurface surface;
  surface.height_m = level_m;
  findInnerCells(context, group, fit, level_m, cells);
  meanOf(cells, INFINITY, surface);
  if (group.scale.flat) {
    for (int i = 0; i < kTrimRounds; ++i) meanOf(cells, group.scale.band_m, surface);
  }
  surface.slope = slopeOf(cells, fit.rectangle);
  surface.uneven_m = unevenness(cells, fit.rectangle, surface.height_m);
  surface.whole = seenAllOver(cells, fit.rectangle);
  if (!group.scale.flat && surface.whole) {
    surface.height_m += rimCorrection(cells, fit.rectangle, fit.rounding_m);
  }
  return surface;
}

}  // namespace mixed_palletizing::detection
