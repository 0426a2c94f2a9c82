// The play of a planner that knows the order of arrival: what knowing it would be worth.
#pragma once

#include <vector>

#include <mixed_palletizing/planning/play_arrivals.hpp>

namespace mixed_palletizing::planning {

/// As playArrivals(), with every arrival known: the weights of the policy are searched for this very order, from the
/// options' on, for as long as the budget of all decisions lasts (without one `kKnownOrderPlays` plays); the best play
/// counts. Its gripper, rules and arrival are those of playArrivals(). Arguments must be sound.
PlayResult playKnownOrder(const packing::Order& order, const std::vector<int>& arrival,
                          const PlayOptions& options);

constexpr int kKnownOrderPlays = 400;

}  // namespace mixed_palletizing::planning
