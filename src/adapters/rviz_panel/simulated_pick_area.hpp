// In a simulated cell nobody moves the boxes when a person reports: the panel takes them away.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <geometry_msgs/PointStamped.h>

#include <mixed_palletizing/BoxArray.h>
#include <mixed_palletizing/ChooseNextPick.h>

#include "cell_link.hpp"

namespace mixed_palletizing::rviz_panel {

/// The boxes that leave the pick area when a decision is reported as placed or discarded.
struct LeavingBoxes {
  std::uint64_t decision_id = 0;
  std::vector<geometry_msgs::PointStamped> tops;  ///< in the base frame
};

/// The chosen box, or all when none of them fits.
LeavingBoxes leavingBoxes(const BoxArray& seen, const ChooseNextPickResponse& answer);

/// Takes the boxes out of the cell's simulated pick area; does nothing in a cell with a real one. Returns what became
/// of the last one, for people; empty when nothing was to be done.
std::string takeFromSimulation(CellLink& link, const LeavingBoxes& boxes, bool discard);

}  // namespace mixed_palletizing::rviz_panel
