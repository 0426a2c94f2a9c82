// Outline samples that say where one side of a rectangle is.
#pragma once

#include <vector>

#include <mixed_palletizing/geometry/rectangle.hpp>

#include "edge_walks.hpp"

namespace mixed_palletizing::detection {

/// A sample in the rectangle's axes, as seen by one side.
struct Vote {
  double across = 0.0;  ///< outward from the rectangle's centre [m]
  double along = 0.0;   ///< counter-clockwise along the side, from its middle [m]
  double pixel = 0.0;   ///< length of a pixel across the side [m]
  double weight = 1.0;
};

struct SideVotes {
  std::vector<Vote> votes;
  double wall_share = 0.0;  ///< of the votes: the side stands against something higher
  int crossings = 0;  ///< grid lines that the side crosses against the direction its samples were found in
};

/// Ends of the surface within `gate_m` of the side, walked to from inside, and not within `corner_m` of its ends;
/// of rows and columns those that cross the side more squarely.
void collectVotes(const std::vector<EdgeSample>& samples, const geometry::Rectangle& rectangle,
                  std::size_t side, double gate_m, double corner_m, SideVotes& result);

/// True when the votes are enough, and spread along enough of the side, to say where it is.
bool enoughVotes(const SideVotes& votes, double half_along_m);

/// Mean length of a pixel across the side: what one tooth of its saw measures.
double meanPixel(const SideVotes& votes);

}  // namespace mixed_palletizing::detection
