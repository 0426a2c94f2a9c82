// The last stretch on which a box comes to its place.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/planning/gripper_envelope.hpp>

namespace mixed_palletizing::planning {

/// A slanted last stretch keeps a box off the neighbours it ends up beside until it is down. The default lowers
/// straight.
struct ApproachOptions {
  int sideways = 0;  ///< [mm] along x and along y, away from neighbours
  int height = 0;    ///< [mm] from which the stretch begins; 0 = always straight
};

std::vector<std::string> problems(const ApproachOptions& options);

/// The movement [mm] of the last stretch to the place, z negative; {0, 0, 0} = straight down all the way, which
/// is always free where clears() holds. It comes from the sides on which nothing stands within `sideways` and
/// whose opposite has a neighbour; box and gripper touch no placed box on the stretch, nor above its beginning.
packing::Vec3 lastStretch(const ApproachOptions& options, const GripperEnvelope& gripper,
                          const packing::PalletState& pallet, const packing::Placement& placement);

}  // namespace mixed_palletizing::planning
