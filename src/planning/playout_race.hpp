// A race between placements: all play the same sampled futures, those clearly behind drop out and others take their
// lanes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <mixed_palletizing/planning/next_pick.hpp>
#include <mixed_palletizing/planning/playout.hpp>

#include "sampled_futures.hpp"
#include "scored_placements.hpp"

namespace mixed_palletizing::planning {

class PlayoutRace {
 public:
  struct Runner {
    packing::Placement placement;
    PlayoutStart start;
    std::vector<PlayoutEnd> ends;  ///< of the first futures
    bool racing = true;
  };

  /// `pairs`: best first, at least one; `lanes` of them race at a time; `engines`: one for each thread. What is
  /// referred to must outlive the race.
  PlayoutRace(const Situation& situation, const std::vector<ScoredPlacement>& pairs, int lanes,
              std::vector<Playout>& engines, const SampledFutures& futures);

  /// `samples` futures at most for each of the first pairs; without a number until `stop` cuts in, and pairs that
  /// drop out are replaced by the next. Ends before that when the decision is certain or one runner is left.
  void run(std::optional<int> samples, const packing::StopCallback& stop);

  /// Looks at more pairs: the first `pairs` of them play `futures` futures, the better half of them twice as many, and so
  /// on until two are left that have played as many as the leader so far, which stays among them.
  void halve(std::size_t pairs, std::size_t futures, const packing::StopCallback& stop);

  /// Those that raced, in the order of the pairs.
  const std::vector<Runner>& runners() const { return runners_; }

  /// Of the racing ones that played the most futures, the one with the best mean value; the earlier of equals.
  std::size_t leader() const;

  /// The mean value of a runner's futures: what a race is about.
  double meanValue(const Runner& runner) const;

 private:
  void enter();
  bool enterMore(std::size_t most);
  bool playUntil(std::size_t rounds, const packing::StopCallback& stop);
  bool catchUp(std::size_t rounds, const packing::StopCallback& stop);
  void dropWorseHalf(std::size_t rounds, std::size_t kept);
  void dropThoseBehind();
  std::size_t racing() const;
  std::size_t fewestEnds() const;
  bool certain() const;
  bool noDifference() const;
  double value(const PlayoutEnd& end) const;

  const std::vector<ScoredPlacement>& pairs_;
  std::size_t lanes_;
  std::vector<Playout>& engines_;
  const SampledFutures& futures_;
  PlayoutStart start_;           ///< before any placement
  std::vector<Runner> runners_;  ///< of the first pairs
};

}  // namespace mixed_palletizing::planning
