// Pieces of level surface: cells that go on into each other without a step, joined by union-find.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cell_grid.hpp"
#include "sensor_noise.hpp"

namespace mixed_palletizing::detection {

/// A connected level surface. Heights follow the plane height(x, y) = mean + slope . ((x, y) - center).
struct LevelPiece {
  std::size_t points = 0;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< of the points, base frame [m]
  double height_m = 0.0;                             ///< mean
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double rms_m = 0.0;             ///< of the cells from the plane
  double depth_m = 0.0;           ///< mean distance along the optical axis
  std::size_t cell = 0;           ///< the first of its cells
  int row_min = 0, row_max = -1;  ///< cells
  int col_min = 0, col_max = -1;
  Eigen::Vector2d low = Eigen::Vector2d::Zero();  ///< bounds of the cells' places
  Eigen::Vector2d high = Eigen::Vector2d::Zero();

  double heightAt(const Eigen::Vector2d& place) const { return height_m + slope.dot(place - center); }
};

class LevelPieces {
 public:
  /// Finds the pieces that are large and thick enough to be a top or a part of one.
  void find(const CellGrid& cells, const SensorNoise& noise, std::size_t min_points);

  const std::vector<LevelPiece>& pieces() const { return pieces_; }

  /// Number of the piece that a cell belongs to; -1 for none.
  int pieceOf(std::size_t cell) const { return labels_[cell]; }

 private:
  /// Connected cells that may become a piece.
  struct Count {
    std::size_t root = 0;  // the first of them
    std::size_t points = 0;
    double depth = 0.0;  // sum over the points [m]
    int cells = 0;
    int core = 0;
    int piece = -1;
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
  int root(int cell);
  void join(const CellGrid& cells, const SensorNoise& noise);
  void collect(const CellGrid& cells, const SensorNoise& noise, std::size_t min_points);
  void measure(const CellGrid& cells);
  bool trim(const CellGrid& cells, const SensorNoise& noise, std::size_t first);

  std::vector<char> active_;  // cells that are still to be looked at
  std::vector<int> parents_;  // a cell before it, or itself; -1: not level
  std::vector<int> labels_;
  std::vector<Count> counts_;
  std::vector<std::size_t> sizes_;   // cells of each piece as it was collected
  std::vector<std::size_t> starts_;  // of each piece's heights
  std::vector<std::size_t> next_;    // of each piece: where its next height goes
  std::vector<float> heights_;
  std::vector<std::pair<float, float>>
      kept_;                     // middle height of each piece, and how far its cells may lie from it
  std::vector<PlaneSums> sums_;  // of each piece
  std::vector<LevelPiece> pieces_;
};

}  // namespace mixed_palletizing::detection
