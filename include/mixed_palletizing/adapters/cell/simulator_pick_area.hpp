// The pick area of the simulated cell: boxes of an order arrive, lie in front of the camera, and are taken away.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <mixed_palletizing/adapters/cell/simulator_layout.hpp>
#include <mixed_palletizing/instances/instance.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::cell {

struct PickAreaBox {
  int item = 0;                ///< index in the sequence of arrival
  int type = 0;                ///< index in the order's types
  simulation::SceneBox solid;  ///< stands as the order gives its size: z up
};

/// Rules of play: the first n_pick boxes lie there; whenever a box is taken for packing the next of the arrival
/// join, so that there are n_pick again; after boxes were thrown out, the next n_pick come together once none is
/// left. The same arguments give the same places.
class PickArea {
 public:
  /// `n_pick` = 0: the instance's. Throws std::invalid_argument for an unsound instance, n_pick below 0, or when
  /// the view has no room for the n_pick largest boxes.
  PickArea(const instances::Instance& instance, int n_pick, const CellLayout& layout, std::uint64_t seed);

  /// What lies there now, in order of arrival.
  const std::vector<PickAreaBox>& boxes() const { return boxes_; }

  /// How many are still to come.
  std::size_t waiting() const { return arrival_.size() - next_; }

  /// Index of the box that contains the point (world frame [m]) or comes nearest to it within `tolerance_m`.
  std::optional<std::size_t> find(const Eigen::Vector3d& point_world, double tolerance_m) const;

  /// Takes boxes()[index] away, lets the next ones arrive, and answers the taken one. Throws
  /// std::invalid_argument for an index out of range.
  PickAreaBox take(std::size_t index, bool discard);

 private:
  PickAreaBox arriving() const;
  void arrive();
  void fill();
  bool layAfresh(std::vector<PickAreaBox>& boxes);
  void requireRoom();

  packing::Order order_;
  std::vector<int> arrival_;  // types
  std::size_t n_pick_ = 0;
  CellLayout layout_;
  std::mt19937_64 random_;
  std::size_t next_ = 0;  // index in the arrival
  std::vector<PickAreaBox> boxes_;
};

}  // namespace mixed_palletizing::cell
