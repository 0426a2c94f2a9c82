// The room a gripper takes over and beside the box it lowers.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>

namespace mixed_palletizing::planning {

/// A cuboid centred over the box, without end upwards, in the pallet frame [mm]. The default takes no room.
struct GripperEnvelope {
  int size_x = 0;
  int size_y = 0;
  int reach = 0;  ///< how far it reaches below the top of the box

  bool isThere() const { return size_x > 0 && size_y > 0; }
};

std::vector<std::string> problems(const GripperEnvelope& envelope);

/// The gripper touches no placed box while it lowers this one to its place. (That the box itself does not is a
/// rule of the pallet.)
bool clears(const GripperEnvelope& envelope, const packing::PalletState& pallet,
            const packing::Placement& placement);

}  // namespace mixed_palletizing::planning
