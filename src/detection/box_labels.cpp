#include "box_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

/// A box as points are held against it.
struct Solid {
  Eigen::Vector2f center, axis;
  Eigen::Array2f half;  // with the margin
  float low, top;

  /// Distance by which a point lies outside of the footprint, negative inside [m].
  float outside(float x, float y) const {
    const Eigen::Vector2f d(x - center.x(), y - center.y());
    const Eigen::Array2f local(d.dot(axis), axis.x() * d.y() - axis.y() * d.x());
    return (local.abs() - half).maxCoeff();
  }
  bool holds(const Eigen::Vector3f& p) const {
    return p.z() > low && p.z() < top && outside(p.x(), p.y()) <= 0.0f;
  }
};

std::vector<Solid> solidsOf(const ClusterLimits& limits, const std::vector<FoundBox>& boxes) {
  std::vector<Solid> solids;
  for (const FoundBox& found : boxes) {
    Solid solid;
    solid.center = found.footprint.center.cast<float>();
    solid.axis = found.footprint.axisX().cast<float>();
    solid.half = 0.5f * found.footprint.size.cast<float>().array() + limits.distance_m;
    solid.low = std::max(limits.low_m, static_cast<float>(found.bottom_m) + 0.5f * limits.low_m);
    solid.top = static_cast<float>(found.top_m);
    solids.push_back(solid);
  }
  return solids;
}

/// Labels the points of the cells that lie near some box.
class Labeller {
 public:
  Labeller(const BaseCloud& cloud, const CellGrid& cells, const ClusterLimits& limits,
           std::vector<FoundBox>& boxes, std::vector<std::uint16_t>& labels)
      : cloud_(cloud), cells_(cells), solids_(solidsOf(limits, boxes)), boxes_(boxes), labels_(labels) {}

  /// Returns whether most of the cell's points belong to boxes.

  bool labelCell(int row, int col) {
    const Cell& cell = cells_.at(row, col);
    const int k = cells_.cellPx();
    count_ = 0;
    for (std::size_t i = 0; i < solids_.size() && count_ < candidates_.size(); ++i) {
      const float outside = solids_[i].outside(cell.x, cell.y);
      // The cell's mean may lie between two surfaces: a wide first look.
      if (outside > std::max(kReach, kReachSpreads * cell.spread)) continue;
      const bool whole = cell.above == k * k && outside < -kReach && cell.height < solids_[i].top - kReach &&
                         cell.height > solids_[i].low + kReach && cell.spread < kReach / kReachSpreads;
      if (whole) {
        fill(row, col, i);
        return true;
      }
      candidates_[count_++] = i;
    }
    if (count_ == 0) return false;
    int labelled = 0;
    for (int r = row * k; r < std::min((row + 1) * k, cloud_.height()); ++r) {
      for (int c = col * k; c < std::min((col + 1) * k, cloud_.width()); ++c)
        labelled += labelPoint(r, c) ? 1 : 0;
    }
    return 2 * labelled > cell.above;
  }

 private:
  static constexpr float kReach = 0.012f;  // [m]
  static constexpr float kReachSpreads = 4.0f;

  std::size_t place(int row, int col) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cloud_.width()) +
           static_cast<std::size_t>(col);
  }
  static std::uint16_t labelOf(std::size_t box) {
    return static_cast<std::uint16_t>(std::min<std::size_t>(box + 1, UINT16_MAX));
  }

  /// Every pixel of a cell whose points all lie deep in one box.
  void fill(int row, int col, std::size_t box) {
    const int k = cells_.cellPx();
    for (int r = row * k; r < (row + 1) * k; ++r) {
      std::fill_n(labels_.begin() + static_cast<std::ptrdiff_t>(place(r, col * k)), k, labelOf(box));
    }
    boxes_[box].box.point_count += static_cast<std::uint32_t>(k * k);
  }

  /// Boxes that touch share their margins: a point belongs to the box that it lies deepest in.
  bool labelPoint(int row, int col) {
    const Eigen::Vector3f p = cloud_.point(row, col);
    float deepest = INFINITY;
    std::size_t best = 0;
    for (std::size_t n = 0; n < count_; ++n) {
      const Solid& solid = solids_[candidates_[n]];
      if (!solid.holds(p)) continue;
      const float outside = solid.outside(p.x(), p.y());
      if (outside >= deepest) continue;
      deepest = outside;
      best = candidates_[n];
    }
    if (!(deepest < INFINITY)) return false;
    labels_[place(row, col)] = labelOf(best);
    ++boxes_[best].box.point_count;
    return true;
  }

  const BaseCloud& cloud_;
  const CellGrid& cells_;
  const std::vector<Solid> solids_;
  std::vector<FoundBox>& boxes_;
  std::vector<std::uint16_t>& labels_;
  std::array<std::size_t, 4> candidates_{};
  std::size_t count_ = 0;
};

}  // namespace

void labelBoxes(const BaseCloud& cloud, const CellGrid& cells, const ClusterLimits& limits,
                std::vector<FoundBox>& boxes, std::vector<std::uint16_t>& labels, std::vector<char>& taken) {
  Labeller labeller(cloud, cells, limits, boxes, labels);
  taken.assign(cells.size(), 0);
  cells.forEachFilled(
      [&](std::size_t i, int row, int col) { taken[i] = labeller.labelCell(row, col) ? 1 : 0; });
}

}  // namespace mixed_palletizing::detection
