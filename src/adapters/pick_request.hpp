// A request of choose_next_pick as the session sees it: which order line each available box belongs to.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <mixed_palletizing/ChooseNextPick.h>
#include <mixed_palletizing/adapters/planner_options.hpp>
#include <mixed_palletizing/planning/pallet_session.hpp>

namespace mixed_palletizing::adapters {

/// Every fault of a request that can be seen without the order; empty when there is none.
std::string faultOf(const ChooseNextPickRequest& request, int max_available);

/// The available boxes with their order lines.
struct IdentifiedBoxes {
  std::vector<PickOption> options;         ///< one for every box; UNKNOWN_BOX and AMBIGUOUS_BOX are final
  std::vector<int> types;                  ///< of the identified boxes
  std::vector<std::size_t> request_index;  ///< of the identified boxes: where they are in the request
};

/// Matches every box with the open order's lines. More boxes of a type than the order still needs are
/// UNKNOWN_BOX, the later ones first.
IdentifiedBoxes identify(const ChooseNextPickRequest& request, const planning::PalletSession& session,
                         const planning::MatchingOptions& matching);

/// The status when not one box was identified.
std::uint8_t nothingIdentified(const IdentifiedBoxes& boxes);

}  // namespace mixed_palletizing::adapters
