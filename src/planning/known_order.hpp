// The play of a planner that knows the order of arrival: what knowing it would be worth.
#pragma once

#include <vector>

#include <mixed_palletizing/planning/play_arrivals.hpp>

namespace mixed_palletizing::planning {

/// As playArrivals(), with every arrival known: a beam search over plays of the policy, wider and wider for as long as
/// the budget of all decisions lasts (without one `kKnownOrderPlays` plays); the fullest pallet counts. Its gripper, rules and arrival are those of playArrivals(). Arguments must be sound.
PlayResult playKnownOrder(const packing::Order& order, const std::vector<int>& arrival,
                          const PlayOptions& options);

constexpr int kKnownOrderPlays = 400;

}  // namespace mixed_palletizing::planning
