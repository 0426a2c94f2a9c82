// Orders, placements and the pallet's state <-> messages: metres outside, whole millimetres inside.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>

#include <mixed_palletizing/OrderLine.h>
#include <mixed_palletizing/PalletState.h>
#include <mixed_palletizing/PalletSummary.h>
#include <mixed_palletizing/Placement.h>
#include <mixed_palletizing/packing/types.hpp>
#include <mixed_palletizing/planning/pallet_session.hpp>

namespace mixed_palletizing::adapters {

/// An order as it comes from outside.
struct OrderRequest {
  geometry_msgs::Vector3 size;  ///< packing volume [m]
  std::vector<OrderLine> lines;
  double gap = 0.0;                ///< [m]
  double min_support_ratio = 0.0;  ///< 0 = 1
  std::uint8_t knowledge = 0;      ///< as in StartPallet
  std::vector<double> expected = {};
};

/// An order, or everything that is wrong with the request.
struct ReadOrder {
  packing::Order order;
  planning::OrderKnowledge knowledge;
  std::vector<std::string> problems;
};

/// Sizes of boxes and gaps are rounded up to whole millimetres, the packing volume down.
ReadOrder readOrder(const OrderRequest& request);

std::vector<OrderLine> toLines(const packing::Order& order);

/// The placement with the axes of the order line's size.
Placement toMessage(const packing::Placement& placement, const packing::Order& order);

/// Puts the last stretch [mm] in a placement; {0, 0, 0} = straight down.
void setApproach(Placement& placement, const packing::Vec3& last_stretch);

/// Turns the pose so that its axes are those of a box that measures `own_size` [m] along its own x, y, z: the
/// assignment of axes that fits the placed size best, upright and unturned if possible.
void alignPose(Placement& placement, const std::array<double, 3>& own_size);

/// Where a measured pose of a box's centre (pallet frame) puts it.
struct MeasuredPlacement {
  std::optional<packing::Placement> placement;  ///< the planned one when the deviation is within tolerance
  std::string problem;                          ///< when there is none
};

/// The position is rounded to whole millimetres; the box must stand along the pallet's sides within
/// `angle_tolerance_rad`, and keeps the planned size. Deviations of all coordinates up to
/// `position_tolerance_m` are within the plan: the gap is there for them.
MeasuredPlacement measuredPlacement(const geometry_msgs::Pose& pose, const packing::Placement& planned,
                                    double position_tolerance_m, double angle_tolerance_rad);

/// All of the state but the header.
PalletState toMessage(const planning::PalletSession& session);

PalletSummary toMessage(const planning::PalletSummary& summary);

}  // namespace mixed_palletizing::adapters
