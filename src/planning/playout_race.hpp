// A race between placements: all play the same sampled futures, those clearly behind drop out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <mixed_palletizing/packing/random.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>
#include <mixed_palletizing/planning/playout.hpp>

#include "scored_placements.hpp"

namespace mixed_palletizing::planning {

class PlayoutRace {
 public:
  struct Runner {
    packing::Placement placement;
    PlayoutStart start;
    std::vector<PlayoutEnd> ends;  ///< of complete rounds only
    bool racing = true;
  };

  /// `pairs`: best first; `engines`: one for each thread, at least one.
  PlayoutRace(const Situation& situation, const std::vector<ScoredPlacement>& pairs,
              std::vector<Playout>& engines, std::uint64_t seed);

  /// At most `samples` rounds, fewer when one runner is left or `stop` cuts in.
  void run(int samples, const packing::StopCallback& stop);

  const std::vector<Runner>& runners() const { return runners_; }

  /// Of those still racing, the one with the best mean value; the earlier of equals.
  std::size_t leader() const;

  /// The mean value of a runner's futures: what a race is about.
  double meanValue(const Runner& runner) const;

 private:
  std::vector<int> drawArrival();
  bool playRounds(int rounds, const packing::StopCallback& stop);
  void dropThoseBehind();
  bool onlyOneFuture() const;
  bool noDifference() const;
  double value(const PlayoutEnd& end) const;

  std::vector<Playout>& engines_;
  packing::Random random_;
  std::vector<Runner> runners_;
  std::vector<int> to_come_;      ///< known
  std::vector<double> forecast_;  ///< expected beside them, per type; empty = none
};

}  // namespace mixed_palletizing::planning
