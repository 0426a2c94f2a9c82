// Random states of sessions in which a decision is asked for.
#pragma once

#include <random>
#include <string>
#include <vector>

#include <mixed_palletizing/planning/pallet_session.hpp>

namespace mixed_palletizing::bench {

enum class WorldKind {
  kUsual,       ///< an order of the generator, 1 to 10 boxes visible, any rules
  kLargeOrder,  ///< thousands of small boxes of up to 200 types, up to 100 visible
  kManyBoxes,   ///< 10,000 boxes visible
};

const char* toString(WorldKind kind);

/// A session part of the way through its order, and what can be asked of it.
struct World {
  planning::PlannerOptions options;
  planning::SessionState state;

  /// Visible types, drawn anew.
  std::vector<int> draw(std::mt19937_64& rng, WorldKind kind) const;
};

World randomWorld(std::mt19937_64& rng, WorldKind kind);

}  // namespace mixed_palletizing::bench
